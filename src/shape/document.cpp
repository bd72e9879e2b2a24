#include "document.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "solid_json.h"

namespace roomgen::shape::detail {

namespace {

constexpr int max_nesting = 32;
constexpr std::size_t max_materials = 256;
constexpr std::size_t max_connections = 1024;
constexpr std::size_t max_reference = 1000;

int nesting(const Json& json, std::size_t& values) {
  ++values;
  int deepest = 0;
  if (json.is_structured())
    for (const auto& element : json) deepest = std::max(deepest, 1 + nesting(element, values));
  return deepest;
}

// Paths and labels of everything that a list of components is written with.
struct Named {
  std::string path, label;
  bool recipe = false;  // parts of what it uses are not seen here
};

void collect(const Json& components, const std::string& prefix, std::vector<Named>& names) {
  for (const auto& component : components) {
    const std::string path = prefix + component.value("name", "");
    names.push_back({path, component.value("label", ""), component.contains("use")});
    if (component.contains("group")) collect(component["group"]["components"], path + ".", names);
  }
}

void collect(const std::vector<Component>& components, const std::string& prefix,
             std::vector<Named>& names) {
  for (const auto& component : components) {
    const std::string path = prefix + component.name;
    names.push_back({path, component.label, false});
    if (const auto* group = std::get_if<Group>(&component.solid))
      collect(group->components, path + ".", names);
  }
}

bool has(const std::vector<Named>& names, const std::string& reference) {
  return std::any_of(names.begin(), names.end(), [&](const Named& named) {
    return refers_to(reference, named.path, named.label) ||
           (named.recipe && reference.rfind(named.path + ".", 0) == 0);
  });
}

void report_unknown(const JsonReader& json, const std::string& reference,
                    const std::vector<Named>& names) {
  std::vector<std::string> known;
  for (const auto& named : names) {
    known.push_back(named.path);
    if (!named.label.empty()) known.push_back(named.label);
  }
  const std::string close = closest_name(reference, known);
  json.report("no component is named or labelled \"" + reference + "\"" +
              (close.empty() ? "" : "; did you mean \"" + close + "\"?"));
}

bool is_part_of_room(const std::string& name) {
  return name == "floor" || name == "wall";
}

// The name of a part without the number of its copy.
std::string_view without_number(std::string_view part) {
  const auto dash = part.rfind('-');
  if (dash == std::string_view::npos || dash + 1 == part.size()) return part;
  const auto digits = part.substr(dash + 1);
  const bool number = digits.find_first_not_of("0123456789") == std::string_view::npos;
  return number ? part.substr(0, dash) : part;
}

}  // namespace

void check_head(const JsonReader& document, const Numbers& numbers) {
  if (!document.is_object()) return document.report("expected a shape program, an object");
  std::size_t values = 0;
  if (nesting(*document.raw(), values) > max_nesting)
    return document.report("nested more than " + std::to_string(max_nesting) + " deep");
  // A large recipe that is used often is as much work as many formulas.
  if (!numbers.spend(document, values)) return;
  if (document["format"].text_or("") != "roomgen-shape")
    document.report("not a shape program: \"format\" must be \"roomgen-shape\"");
  if (document["version"].integer_or(1, 1, 1000) != 1)
    document["version"].report("this version of roomgen reads version 1 only");
}

std::vector<Surface> read_surfaces(const JsonReader& materials, const Numbers& numbers) {
  std::vector<Surface> surfaces;
  for (const auto& [name, json] : materials.members()) {
    if (surfaces.size() == max_materials) {
      materials.report("more than " + std::to_string(max_materials) + " materials");
      break;
    }
    if (name.empty() || name.size() > max_reference)
      json.report("a material needs a name of at most 1000 bytes");
    surfaces.push_back(read_surface(name, json, numbers));
  }
  return surfaces;
}

std::map<std::string, std::string> same_names(const std::vector<Surface>& surfaces) {
  std::map<std::string, std::string> names;
  for (const auto& surface : surfaces) names.emplace(surface.name, surface.name);
  return names;
}

std::vector<std::pair<std::string, std::string>> read_connections(
    const JsonReader& document, const std::vector<Component>& components, const Numbers& numbers) {
  std::vector<std::pair<std::string, std::string>> connections;
  if (!document["connections"].exists()) return connections;
  std::vector<Named> written, made;
  collect((*document.raw())["components"], "", written);
  collect(components, "", made);
  for (const auto& pair : document["connections"].elements(max_connections)) {
    if (!numbers.spend(pair, written.size() + made.size())) break;
    const auto ends = pair.elements();
    if (ends.size() != 2) {
      pair.report("expected two names");
      return connections;
    }
    const std::string first = ends[0].text(max_reference), second = ends[1].text(max_reference);
    const bool of_room = is_part_of_room(second) && !has(written, second);
    if (!has(written, first) || !(of_room || has(written, second))) {
      const std::size_t unknown = has(written, first) ? 1 : 0;
      report_unknown(ends[unknown], unknown == 0 ? first : second, written);
      return connections;
    }
    if (has(made, first) && (of_room || has(made, second))) connections.emplace_back(first, second);
  }
  return connections;
}

}  // namespace roomgen::shape::detail

namespace roomgen::shape {

bool refers_to(std::string_view reference, std::string_view path, std::string_view label) {
  if (reference.empty()) return false;
  if (reference == label) return true;
  const auto names = split(reference, '.'), parts = split(path, '.');
  if (names.size() > parts.size()) return false;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k] == parts[k] || names[k] == detail::without_number(parts[k])) continue;
    return k + 1 == names.size() && k > 0 && names[k] == label;
  }
  return true;
}

}  // namespace roomgen::shape
