#include "program_repair.h"

#include <algorithm>
#include <map>
#include <set>

#include "chat/loose_json.h"
#include "roomgen/base/text.h"
#include "roomgen/shape/program.h"
#include "shape/color.h"
#include "shape/motifs.h"

namespace roomgen::create {

namespace {

using Names = std::vector<std::string>;

constexpr std::size_t most_name = 60;  // bytes; copies get numbers after it
// Objects of more members are left to the reader of programs: no repair makes sense of them, and
// looking up members takes time that grows with them.
constexpr std::size_t most_members = 64;
constexpr std::size_t most_materials = 256, most_connections = 1024;
constexpr std::size_t most_reference = 1000;  // bytes
// Of what has a colour that nobody knows: no reason to lose a program, or to ask for it again.
const std::string plain_color = "#b8b0a4";

const Names head_keys = {"format", "version",   "name",       "about",      "parameters",
                         "let",    "materials", "components", "connections"};
const Names component_keys = {"name", "label", "material", "operations", "scale",    "rotate",
                              "at",   "when",  "use",      "with",       "materials"};
const Names solid_keys = {"box",   "cylinder", "frustum", "ellipsoid", "prism",
                          "plane", "lathe",    "sweep",   "extrude",   "loft",
                          "leaf",  "cushion",  "picture", "group",     "height_field", "text"};
const Names surface_keys = {"color",   "roughness", "metalness", "opacity",
                            "pattern", "second",    "scale",     "glow"};
// What models call them, and what they are called.
const std::map<std::string, std::string> component_words = {{"position", "at"},
                                                            {"location", "at"},
                                                            {"translate", "at"},
                                                            {"translation", "at"},
                                                            {"id", "name"},
                                                            {"rotation", "rotate"},
                                                            {"modifiers", "operations"},
                                                            {"cone", "frustum"},
                                                            {"cube", "box"},
                                                            {"extrusion", "extrude"},
                                                            {"heightfield", "height_field"}};

bool has(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string text_at(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

void rename_key(Json& object, const std::string& from, const std::string& to) {
  if (!object.contains(from) || object.contains(to)) return;
  Json value = std::move(object[from]);
  object.erase(from);
  object[to] = std::move(value);
}

// Letters, digits, - and _ only.
std::string plain_name(const std::string& text) {
  std::string name;
  for (const char c : shortened(text, most_name)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '-' || c == '_';
    name += plain ? c : '-';
  }
  return name;
}

// The colour itself, or the last of its words that is one: "matte black" is black.
std::string known_color(const std::string& text) {
  if (shape::parse_color(text)) return text;
  const auto pieces = words(text);
  for (std::size_t k = pieces.size(); k-- > 0;)
    if (shape::parse_color(pieces[k])) return pieces[k];
  return "";
}

/// Mends one program.
class Repair {
 public:
  Repair(Json& program, std::vector<std::string>& repairs) : program_(program), repairs_(repairs) {}

  void run() {
    if (program_.size() > most_members) return;
    rename_key(program_, "parts", "components");
    head();
    // Parts may bring materials along; a member more would move the list of parts.
    if (!program_.contains("materials")) program_["materials"] = Json::object();
    materials();
    if (program_.contains("components")) components(program_["components"]);
    connections();
  }

 private:
  void note(const std::string& what) {
    if (std::find(repairs_.begin(), repairs_.end(), what) == repairs_.end())
      repairs_.push_back(what);
  }

  void head() {
    if (text_at(program_, "format") != "roomgen-shape") program_["format"] = "roomgen-shape";
    program_["version"] = 1;
    drop_unknown(program_, head_keys, "the program");
    if (program_.contains("name") && !program_["name"].is_string()) program_.erase("name");
    if (program_.contains("about") && !program_["about"].is_string()) program_.erase("about");
  }

  void drop_unknown(Json& object, const Names& known, const std::string& of) {
    Names unknown;
    for (const auto& [key, value] : object.items())
      if (!has(known, key)) unknown.push_back(key);
    for (const auto& key : unknown) {
      object.erase(key);
      note("\"" + shortened(key, 40) + "\" of " + of + " means nothing and was left out");
    }
  }

  // An object of surfaces, also when it is a list or holds colours only.
  void materials() {
    if (!program_["materials"].is_structured() || program_["materials"].size() > most_materials)
      return;
    Json mended = Json::object();
    const Json given = std::move(program_["materials"]);
    for (const auto& [key, value] : given.items()) {
      const std::string name = value.is_object() && given.is_array() ? text_at(value, "name") : key;
      Json surface = value.is_string() ? Json{{"color", value}} : value;
      if (surface.is_object()) mend_surface(surface, name);
      mended[name] = std::move(surface);
    }
    program_["materials"] = std::move(mended);
  }

  void mend_surface(Json& surface, const std::string& name) {
    if (surface.size() > most_members) return;
    rename_key(surface, "colour", "color");
    if (name == text_at(surface, "name")) surface.erase("name");
    drop_unknown(surface, surface_keys, "material \"" + shortened(name, 40) + "\"");
    for (const char* key : {"color", "second"}) {
      const std::string color = text_at(surface, key);
      if (color.empty() || color.front() == '$') continue;
      const std::string known = known_color(color);
      if (known.empty()) {
        note("the colour \"" + shortened(color, 40) + "\" is not known and was left out");
        surface.erase(key);
      } else if (known != color) {
        note("the colour \"" + shortened(color, 40) + "\" was taken as " + known);
        surface[key] = known;
      }
    }
    if (!surface.contains("color")) {
      const std::string known = known_color(name);
      surface["color"] = known.empty() ? plain_color : known;
    }
    const std::string pattern = text_at(surface, "pattern");
    if (!pattern.empty() && pattern.front() != '$' && !has(shape::pattern_names(), pattern) &&
        !shape::find_motif(pattern)) {
      note("the pattern \"" + shortened(pattern, 40) + "\" is not known and was left out");
      surface.erase("pattern");
    }
  }

  void components(Json& list) {
    if (list.is_object()) list = as_list(list);
    if (!list.is_array() || list.size() > shape::max_components) return;
    std::map<std::string, int> taken;
    for (auto& component : list)
      if (component.is_object() && component.size() <= most_members) mend(component, taken);
    drop_empty(list);
  }

  // The last part of an answer that was cut off has a name and little more.
  void drop_empty(Json& list) {
    Json kept = Json::array();
    for (auto& component : list) {
      const bool is_empty =
          component.is_object() && component.size() <= most_members && !component.contains("use") &&
          std::all_of(component.items().begin(), component.items().end(),
                      [](const auto& member) {
                        return has(component_keys, member.key()) ||
                               (has(solid_keys, member.key()) && member.value().empty());
                      });
      if (is_empty)
        note("the part \"" + shortened(text_at(component, "name"), 40) +
             "\" has no solid and was left out");
      else
        kept.push_back(std::move(component));
    }
    if (!kept.empty()) list = std::move(kept);
  }

  // {"seat": {...}, "leg": {...}}
  static Json as_list(const Json& object) {
    Json list = Json::array();
    for (const auto& [name, value] : object.items()) {
      list.push_back(value);
      if (value.is_object() && !value.contains("name")) list.back()["name"] = name;
    }
    return list;
  }

  void mend(Json& component, std::map<std::string, int>& taken) {
    for (const auto& [from, to] : component_words) rename_key(component, from, to);
    gather_solid(component);
    mend_name(component, taken);
    mend_sphere(component);
    mend_material(component);
    rename_key(component, "components", "group");
    if (component.contains("group")) {
      Json& group = component["group"];
      if (group.is_array()) group = Json{{"components", std::move(group)}};
      if (group.is_object() && group.contains("components")) components(group["components"]);
    }
  }

  // {"type": "box", "size": ...} and {"solid": {"type": "box", ...}} as {"box": {"size": ...}}.
  void gather_solid(Json& component) {
    for (const char* key : {"solid", "primitive", "geometry"})
      if (component.contains(key) && component[key].is_object()) {
        const Json inner = std::move(component[key]);
        component.erase(key);
        for (const auto& [name, value] : inner.items())
          if (!component.contains(name)) component[name] = value;
      }
    for (const char* key : {"type", "solid", "primitive", "shape"}) {
      std::string kind = text_at(component, key);
      if (const auto word = component_words.find(kind); word != component_words.end())
        kind = word->second;
      if (kind != "sphere" && !has(solid_keys, kind)) continue;
      component.erase(key);
      if (component.contains(kind)) return;
      Json solid = Json::object();
      Names moved;
      for (const auto& [name, value] : component.items())
        if (!has(component_keys, name)) {
          solid[name] = value;
          moved.push_back(name);
        }
      for (const auto& name : moved) component.erase(name);
      component[kind] = std::move(solid);
      note("solids written beside their type were put in their place");
      return;
    }
  }

  void mend_name(Json& component, std::map<std::string, int>& taken) {
    const std::string given = text_at(component, "name"), label = text_at(component, "label");
    std::string name = plain_name(given.empty() ? label : given);
    if (name.empty()) name = "part";
    const std::string wanted = name;
    int& times = taken[wanted];
    if (++times > 1) name += "_" + std::to_string(times);
    // What is said of one of them is said of all.
    if (name != wanted && label.empty()) component["label"] = wanted;
    if (name != given && !given.empty()) {
      note("the part \"" + shortened(given, 40) + "\" was called " + name);
      if (name == wanted) renamed_[given] = name;
    }
    if (name != given) component["name"] = name;
  }

  static Json twice(const Json& radius) {
    if (radius.is_number()) return 2.0 * radius.get<double>();
    return radius.is_string() ? Json("2 * (" + radius.get<std::string>() + ")") : radius;
  }

  static void mend_sphere(Json& component) {
    rename_key(component, "sphere", "ellipsoid");
    if (!component.contains("ellipsoid")) return;
    Json& solid = component["ellipsoid"];
    if (!solid.is_object() || solid.contains("size") || !solid.contains("radius")) return;
    const Json width = twice(solid["radius"]);
    solid = Json{{"size", Json::array({width, width, width})}};
  }

  // A material that is given in place, or that is only a colour.
  void mend_material(Json& component) {
    const std::string color = text_at(component, "color");
    component.erase("color");
    if (!component.contains("material")) {
      if (!color.empty()) component["material"] = color;
    }
    if (!component.contains("material")) return;
    Json& materials = program_["materials"];
    if (!materials.is_object() || materials.size() >= most_materials) return;
    if (component["material"].is_object()) {
      Json surface = component["material"];
      const std::string name = text_at(component, "name") + "-surface";
      mend_surface(surface, name);
      materials[name] = std::move(surface);
      component["material"] = name;
      return;
    }
    const std::string name = text_at(component, "material");
    if (name.empty() || name.front() == '$' || materials.contains(name)) return;
    const std::string known = known_color(name);
    materials[name] = {{"color", known.empty() ? plain_color : known}};
    note("the material \"" + shortened(name, 40) + "\" was not described; " +
         (known.empty() ? "a plain one was taken" : "its colour was taken"));
  }

  // All that a connection may call the parts: see shape::refers_to().
  static void collect(const Json& components, const std::string& prefix,
                      std::set<std::string>& known) {
    if (!components.is_array()) return;
    for (const auto& component : components) {
      if (!component.is_object()) continue;
      const std::string path = prefix + text_at(component, "name");
      const std::string label = text_at(component, "label");
      known.insert(path);
      if (!label.empty()) known.insert({label, prefix + label});
      if (component.contains("group") && component["group"].is_object() &&
          component["group"].contains("components"))
        collect(component["group"]["components"], path + ".", known);
    }
  }

  void connections() {
    if (!program_.contains("connections") || !program_["connections"].is_array()) {
      program_.erase("connections");
      return;
    }
    std::set<std::string> known = {"floor", "wall"};
    if (program_.contains("components")) collect(program_["components"], "", known);
    Json kept = Json::array();
    for (const auto& pair : program_["connections"]) {
      const auto ends = kept.size() < most_connections ? ends_of(pair) : std::nullopt;
      if (ends)
        connect(*ends, known, kept);
      else
        note("a connection that names no two parts was left out");
    }
    program_["connections"] = std::move(kept);
  }

  void connect(const std::pair<std::string, std::string>& ends, const std::set<std::string>& known,
               Json& kept) {
    auto first = part_named(ends.first, known), second = part_named(ends.second, known);
    if (is_room(first)) std::swap(first, second);  // the room comes second
    if (first.empty() || second.empty() || is_room(first))
      note("the connection of \"" + shortened(ends.first, 40) + "\" and \"" +
           shortened(ends.second, 40) + "\" names no part and was left out");
    else
      kept.push_back(Json::array({first, second}));
  }

  static bool is_room(const std::string& name) { return name == "floor" || name == "wall"; }

  static std::optional<std::pair<std::string, std::string>> ends_of(const Json& pair) {
    if (pair.is_array() && pair.size() == 2 && pair[0].is_string() && pair[1].is_string())
      return std::pair(pair[0].get<std::string>(), pair[1].get<std::string>());
    const Json* from = member(pair, {"from", "a", "first", "part"});
    const Json* to = member(pair, {"to", "b", "second", "with"});
    if (!from || !to || !from->is_string() || !to->is_string()) return std::nullopt;
    return std::pair(from->get<std::string>(), to->get<std::string>());
  }

  // The name or label that is meant: also "legs" for a leg, "leg-0" for one of its copies.
  std::string part_named(const std::string& text, const std::set<std::string>& known) const {
    if (text.size() > most_reference) return "";
    if (const auto other = renamed_.find(text); other != renamed_.end()) return other->second;
    const std::string in_lower = lower(text);
    const std::string one = text.substr(0, text.find_last_not_of("0123456789") + 1);
    const std::string all = !one.empty() && one.back() == '-' ? one.substr(0, one.size() - 1) : one;
    for (const auto& name : {text, in_lower, all, singular(in_lower), plain_name(in_lower)})
      if (known.count(name)) return name;
    return in_lower == "ground" ? "floor" : "";
  }

  Json& program_;
  std::vector<std::string>& repairs_;
  std::map<std::string, std::string> renamed_;
};

}  // namespace

void repair_program(Json& program, std::vector<std::string>& repairs) {
  if (program.is_object()) Repair(program, repairs).run();
}

}  // namespace roomgen::create
