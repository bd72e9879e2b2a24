#include "connection_map.h"

#include <algorithm>
#include <map>
#include <set>

#include "part_roles.h"
#include "roomgen/base/text.h"

namespace roomgen::create::detail {

namespace {

using Parts = std::vector<std::size_t>;

// Beyond this the labels' suggestions are left out: programs of hundreds of unlike parts.
constexpr std::size_t max_links = 4096, most_suggested = 800;

// The path of a copy down to what the reference names: "backrest" means all of "backrest.post-1",
// "post" only that post.
std::string unit_name(const std::string& reference, const Part& part) {
  const auto names = split(reference, '.'), pieces = split(part.name, '.');
  const bool by_label = reference == part.label;
  const bool by_path = names.size() <= pieces.size() && shape::refers_to(reference, part.name, "");
  if (by_label && !by_path) return part.name;
  std::string unit;
  for (std::size_t k = 0; k < std::min(names.size(), pieces.size()); ++k)
    unit += (k ? "." : "") + pieces[k];
  return unit;
}

std::map<std::string, Parts> units(const Assembly& assembly, const std::string& reference) {
  std::map<std::string, Parts> result;
  const auto& parts = assembly.parts();
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (shape::refers_to(reference, parts[k].name, parts[k].label))
      result[unit_name(reference, parts[k])].push_back(k);
  return result;
}

// Where a component has the name, those that only have the label may but need not be meant.
std::map<std::string, Parts> named_units(const Assembly& assembly, const std::string& reference) {
  std::map<std::string, Parts> result;
  const auto& parts = assembly.parts();
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (shape::refers_to(reference, parts[k].name, ""))
      result[unit_name(reference, parts[k])].push_back(k);
  return result.empty() ? units(assembly, reference) : result;
}

Parts all_of(const std::map<std::string, Parts>& units) {
  std::set<std::size_t> all;
  for (const auto& [name, parts] : units) all.insert(parts.begin(), parts.end());
  return {all.begin(), all.end()};
}

Parts without(const Parts& parts, const Parts& others) {
  Parts result;
  std::set_difference(parts.begin(), parts.end(), others.begin(), others.end(),
                      std::back_inserter(result));
  return result;
}

class Map {
 public:
  Map(const Assembly& assembly, Footing footing) : assembly_(assembly), footing_(footing) {}

  std::vector<Link> made() {
    for (const auto& [one, other] : assembly_.program().connections) declare(one, other);
    if (footing_ == Footing::ground) stand();
    suggest();
    return std::move(links_);
  }

 private:
  void declare(const std::string& one, const std::string& other) {
    const auto first = named_units(assembly_, one), second = units(assembly_, other);
    if (second.empty()) {
      if (other == "floor" && footing_ == Footing::ground)
        for (const auto& [name, parts] : first) to_floor(name, parts, true);
      return;
    }
    // Each copy of what is named first; the others only where they would be loose.
    join(first, other, all_of(second), true);
    join(second, one, all_of(first), false);
  }

  void join(const std::map<std::string, Parts>& first, const std::string& name, const Parts& second,
            bool firm) {
    for (const auto& [unit, parts] : first) {
      const Parts others = without(second, parts);
      if (!others.empty()) add({parts, others, false, firm, unit + " and " + name});
    }
  }

  void to_floor(const std::string& name, const Parts& parts, bool firm) {
    on_floor_.insert(parts.begin(), parts.end());
    add({parts, {}, true, firm, name + " and the floor"});
  }

  // Feet stand; where there are none, bases do.
  void stand() {
    const auto& parts = assembly_.parts();
    const auto label = [](const Part& part) { return part.label; };
    const bool feet = std::any_of(parts.begin(), parts.end(),
                                  [&](const Part& part) { return is_foot(label(part)); });
    for (std::size_t k = 0; k < parts.size(); ++k)
      if ((feet ? is_foot(parts[k].label) : is_base(parts[k].label)) && !on_floor_.count(k))
        to_floor(parts[k].name, {k}, feet);
  }

  void suggest() {
    const auto& parts = assembly_.parts();
    if (parts.size() > most_suggested) return;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const auto neighbours = usual_neighbours(parts[k].label);
      Parts others;
      for (std::size_t m = 0; m < parts.size() && !neighbours.empty(); ++m)
        if (m != k && parts[m].source != parts[k].source && is_one_of(parts[m].label, neighbours))
          others.push_back(m);
      if (!others.empty()) add({{k}, others, false, false, parts[k].name});
    }
  }

  void add(Link link) {
    if (links_.size() < max_links) links_.push_back(std::move(link));
  }

  const Assembly& assembly_;
  Footing footing_;
  std::vector<Link> links_;
  std::set<std::size_t> on_floor_;
};

}  // namespace

std::vector<Link> connection_map(const Assembly& assembly, Footing footing) {
  return Map(assembly, footing).made();
}

}  // namespace roomgen::create::detail
