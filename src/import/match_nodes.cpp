#include <map>
#include <optional>

#include "roomgen/import/import.h"
#include "roomgen/scene/scene.h"
#include "scene/plain_names.h"

namespace roomgen {

namespace {

using Nodes = std::vector<const SceneNode*>;

/// The names of a scene's things in files, and in those that three.js has written again.
class NamesOfThings {
 public:
  explicit NamesOfThings(const Scene& scene) {
    PlainNames names;
    written_ = node_names(scene, names);
    for (std::size_t i = 0; i < written_.size(); ++i) things_.emplace(threejs_name(written_[i]), i);
    // Files of earlier versions have the ids for names, whatever is in them.
    for (std::size_t i = 0; i < written_.size(); ++i) {
      ids_.push_back(scene.objects[i].id);
      things_.emplace(threejs_name(ids_[i]), i);
    }
  }

  std::optional<std::size_t> thing_of(const std::string& name) const {
    const auto found = things_.find(threejs_name(name));
    return name.empty() || found == things_.end() ? std::nullopt : std::optional(found->second);
  }
  bool is_exact(const SceneNode& node, std::size_t thing) const {
    return node.name == written_[thing] || node.name == ids_[thing];
  }

 private:
  std::vector<std::string> written_, ids_;
  std::map<std::string, std::size_t> things_;
};

// "chair-0.001": what Blender calls a copy.
std::string name_of_copied(const std::string& name) {
  const auto dot = name.rfind('.');
  const bool is_copy = dot != std::string::npos && dot + 1 < name.size() &&
                       name.find_first_not_of("0123456789", dot + 1) == std::string::npos;
  return is_copy ? name.substr(0, dot) : "";
}

// The only one, or the only one that is called as the thing is, to the letter or nearly.
const SceneNode* choose(const Nodes& nodes, const NamesOfThings& names, std::size_t thing) {
  if (nodes.size() == 1) return nodes.front();
  Nodes exact, similar;
  for (const auto* node : nodes) {
    if (names.is_exact(*node, thing)) exact.push_back(node);
    if (names.thing_of(node->name) == thing) similar.push_back(node);
  }
  const Nodes& best = exact.empty() ? similar : exact;
  return best.size() == 1 ? best.front() : nullptr;
}

}  // namespace

Result<MatchedNodes> match_nodes(const Scene& scene, std::span<const SceneNode> nodes) {
  const NamesOfThings names(scene);
  std::map<std::string, std::size_t> things;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) things.emplace(scene.objects[i].id, i);
  std::vector<Nodes> carriers(scene.objects.size()), namesakes(scene.objects.size());
  MatchedNodes matched;
  for (const auto& node : nodes) {
    if (const auto own = things.find(node.id); own != things.end())
      carriers[own->second].push_back(&node);
    else if (const auto thing = names.thing_of(node.name))
      namesakes[*thing].push_back(&node);
    else if (const auto copied = names.thing_of(name_of_copied(node.name)))
      matched.copies.push_back({node.name, scene.objects[*copied].id});
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const std::string& id = scene.objects[i].id;
    const Nodes& found = carriers[i].empty() ? namesakes[i] : carriers[i];
    matched.nodes.push_back(found.empty() ? nullptr : choose(found, names, i));
    if (found.empty()) continue;
    if (!matched.nodes.back())
      return Error{Error::Kind::invalid_input,
                   "two nodes are " + id + ": " + found[0]->name + " and " + found[1]->name +
                       "; give one of them another name and no \"id\" in its extras"};
    for (const auto* node : carriers[i])
      if (node != matched.nodes.back()) matched.copies.push_back({node->name, id});
  }
  return matched;
}

}  // namespace roomgen
