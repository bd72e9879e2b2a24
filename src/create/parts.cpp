#include "parts.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "roomgen/base/json.h"
#include "roomgen/shape/evaluate.h"

namespace roomgen::create {

namespace {

using shape::Component;
using shape::Group;


std::string label_of(const Component& component, const std::string& inherited) {
  if (!component.label.empty()) return component.label;
  return inherited.empty() ? component.name : inherited;
}

void visit_solids(std::vector<Component>& components, const std::string& inherited,
                  const std::function<void(Component&, const std::string&)>& visit) {
  for (auto& component : components) {
    if (auto* group = std::get_if<Group>(&component.solid)) {
      const std::string label = component.label.empty() ? inherited : component.label;
      visit_solids(group->components, label, visit);
    } else {
      visit(component, label_of(component, inherited));
    }
  }
}

// Glides and screws do not make a leg another thing.
bool is_trifle(std::string_view label) {
  return label == "glide" || label == "cap" || label == "trim" || label == "screw" ||
         label == "plate";
}

bool is_whole(const Component& component, std::string_view label) {
  bool any = false, only = true;
  std::vector<Component> copy = {component};
  visit_solids(copy, "", [&](Component&, const std::string& own) {
    if (own == label) any = true;
    else if (!is_trifle(own)) only = false;
  });
  return any && only;
}

void filter(std::vector<Component>& components, std::string_view label,
            const std::function<bool(Component&)>& keep) {
  for (auto it = components.begin(); it != components.end();) {
    if (is_whole(*it, label)) {
      it = keep(*it) ? it + 1 : components.erase(it);
      continue;
    }
    if (auto* group = std::get_if<Group>(&it->solid)) {
      filter(group->components, label, keep);
      if (group->components.empty()) {
        it = components.erase(it);
        continue;
      }
    }
    ++it;
  }
}

void collect_names(const std::vector<Component>& components, const std::string& prefix,
                   const std::string& inherited,
                   std::vector<std::pair<std::string, std::string>>& names) {
  for (const auto& component : components) {
    const std::string path = prefix + component.name;
    names.emplace_back(path, label_of(component, inherited));
    if (const auto* group = std::get_if<Group>(&component.solid))
      collect_names(group->components, path + ".",
                    component.label.empty() ? inherited : component.label, names);
  }
}

// Groups of this label none of whose pieces bears it: a back of rails and slats.
int count_groups(const std::vector<Component>& components, std::string_view label) {
  int count = 0;
  for (const auto& component : components) {
    const auto* group = std::get_if<Group>(&component.solid);
    if (!group) continue;
    if (component.label == label) ++count;
    else count += count_groups(group->components, label);
  }
  return count;
}

/// What evaluation would call a body, and its material.
struct NamedBody {
  std::string name, label, material;
};

using NamedCopies = std::vector<std::vector<NamedBody>>;

void repeat_copies(NamedCopies& copies, int times) {
  NamedCopies result;
  for (int k = 0; k < times; ++k) result.insert(result.end(), copies.begin(), copies.end());
  copies = std::move(result);
}

void join_copies(NamedCopies& copies) {
  std::vector<NamedBody> joined;
  for (auto& bodies : copies)
    for (auto& body : bodies)
      if (std::none_of(joined.begin(), joined.end(),
                       [&](const NamedBody& other) { return other.material == body.material; }))
        joined.push_back({"", std::move(body.label), std::move(body.material)});
  copies = {std::move(joined)};
}

// The bodies' names without their meshes.
std::vector<NamedBody> named_bodies(const std::vector<Component>& components,
                                    const std::string& outer_label,
                                    const std::string& outer_material) {
  std::vector<NamedBody> result;
  for (const auto& component : components) {
    const std::string& label = component.label.empty() ? outer_label : component.label;
    const std::string& material = component.material.empty() ? outer_material : component.material;
    const auto* group = std::get_if<Group>(&component.solid);
    NamedCopies copies;
    if (group) copies.push_back(named_bodies(group->components, label, material));
    else copies.push_back({{"", label.empty() ? component.name : label, material}});
    for (const auto& operation : component.operations) {
      if (std::holds_alternative<shape::Mirror>(operation)) repeat_copies(copies, 2);
      if (const auto* array = std::get_if<shape::Array>(&operation)) repeat_copies(copies, array->count);
      if (const auto* radial = std::get_if<shape::Radial>(&operation)) repeat_copies(copies, radial->count);
      if (std::holds_alternative<shape::Join>(operation)) join_copies(copies);
    }
    for (std::size_t k = 0; k < copies.size(); ++k) {
      const std::string name = component.name + (copies.size() > 1 ? "-" + std::to_string(k) : "");
      for (auto& body : copies[k]) {
        body.name = body.name.empty() ? name : name + "." + body.name;
        result.push_back(std::move(body));
      }
    }
  }
  return result;
}

}  // namespace

void for_each_part(shape::Program& program, std::string_view label,
                   const std::function<void(Component&)>& visit) {
  visit_solids(program.components, "", [&](Component& component, const std::string& own) {
    if (own == label) visit(component);
  });
}

void filter_wholes(shape::Program& program, std::string_view label,
                   const std::function<bool(Component&)>& keep) {
  filter(program.components, label, keep);
}

int count_parts(const shape::Program& program, std::string_view label) {
  if (shape::component_count(program.components) > shape::max_components) return 0;
  // A leg of several pieces is one leg: its pieces come from one copy of one group.
  std::vector<std::string> wholes;
  for (const auto& body : named_bodies(program.components, "", "")) {
    if (body.label != label) continue;
    const auto dot = body.name.rfind('.');
    const std::string owner = body.name.substr(0, dot);
    const bool piece = dot != std::string::npos && owner.find(label) != std::string::npos;
    wholes.push_back(piece ? owner : body.name);
  }
  if (wholes.empty()) return count_groups(program.components, label);
  std::sort(wholes.begin(), wholes.end());
  return static_cast<int>(std::unique(wholes.begin(), wholes.end()) - wholes.begin());
}

std::map<std::string, int> all_parts(const shape::Program& program) {
  std::vector<std::pair<std::string, std::string>> names;
  collect_names(program.components, "", "", names);
  std::map<std::string, int> counts;
  for (const auto& [name, label] : names)
    if (!counts.count(label)) counts[label] = count_parts(program, label);
  return counts;
}

namespace {

void collect_letters(const Json& drawing, std::string& letters) {
  if (!drawing.is_structured()) return;
  for (const auto& [key, inner] : drawing.items())
    if (key == "text" && inner.is_string())
      letters += " " + inner.get<std::string>();
    else
      collect_letters(inner, letters);
}

}  // namespace

std::string letters_of(const std::vector<shape::Component>& components) {
  std::string letters;
  for (const auto& component : components) {
    if (const auto* group = std::get_if<shape::Group>(&component.solid))
      letters += letters_of(group->components);
    if (const auto* text = std::get_if<shape::TextPart>(&component.solid))
      letters += " " + text->words;
    if (const auto* picture = std::get_if<shape::PicturePart>(&component.solid))
      if (const auto drawing = parse_json(picture->drawing, "drawing"))
        collect_letters(*drawing, letters);
  }
  return letters;
}

Vec3 part_size(const shape::Program& program, std::string_view label) {
  Vec3 largest = Vec3::Zero();
  const auto shape = shape::evaluate(program, shape::for_measuring);
  if (!shape) return largest;
  for (const auto& body : shape->bodies) {
    const Vec3 size = bounds(body.mesh).size();
    if (body.label == label && size.prod() > largest.prod()) largest = size;
  }
  return largest;
}

void prune_connections(shape::Program& program) {
  std::vector<std::pair<std::string, std::string>> names;
  collect_names(program.components, "", "", names);
  const auto exists = [&](const std::string& reference) {
    return reference == "floor" || reference == "wall" ||
           std::any_of(names.begin(), names.end(), [&](const auto& named) {
             return shape::refers_to(reference, named.first, named.second);
           });
  };
  std::erase_if(program.connections,
                [&](const auto& pair) { return !exists(pair.first) || !exists(pair.second); });
}

}  // namespace roomgen::create
