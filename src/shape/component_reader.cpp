#include "component_reader.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "solid_json.h"

namespace roomgen::shape::detail {

namespace {

constexpr int max_count = static_cast<int>(max_components);
constexpr std::size_t max_operations = 32;
constexpr double max_scale = 1000.0;

bool is_name(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_';
  });
}

// Puts names in the scope for as long as it lives.
class CopyIndex {
 public:
  CopyIndex(Scope& scope, int index, int count) : scope_(scope), before_(scope.values) {
    if (const auto outer = before_.find("i"); outer != before_.end())
      scope_.values["j"] = outer->second;
    scope_.values["i"] = static_cast<double>(index);
    scope_.values["n"] = static_cast<double>(count);
  }
  CopyIndex(const CopyIndex&) = delete;
  CopyIndex& operator=(const CopyIndex&) = delete;
  ~CopyIndex() { scope_.values = std::move(before_); }

 private:
  Scope& scope_;
  Values before_;
};

// The first operation that makes numbered copies.
struct Copying {
  std::size_t operation = 0;
  JsonReader settings;
  bool radial = false;
};

std::optional<Copying> copying(const JsonReader& json) {
  if (!json["operations"].is_array()) return std::nullopt;
  const auto operations = json["operations"].elements(max_operations);
  for (std::size_t k = 0; k < operations.size(); ++k) {
    if (!operations[k].is_object()) return std::nullopt;
    for (const char* key : {"array", "radial"})
      if (const auto settings = operations[k][key]; settings.is_object())
        return Copying{k, settings, std::string_view(key) == "radial"};
  }
  return std::nullopt;
}

// Where copy `index` stands, as the operation would have put it.
void place_copy(Component& component, const Operation& operation, int index, int count) {
  if (const auto* array = std::get_if<Array>(&operation)) {
    component.at += index * array->step;
    return;
  }
  const auto& radial = std::get<Radial>(operation);
  const double angle = copy_angle(radial, index, count);
  const Vec2 offset = rotated(Vec2(component.at.head<2>() - radial.center), angle);
  component.at.head<2>() = radial.center + offset;
  component.rotate.z() = wrap_angle(component.rotate.z() + angle);
}

Vec3 read_scale(const JsonReader& json, const Numbers& numbers) {
  if (!json.exists()) return Vec3::Ones();
  const Vec3 scale = json.is_array() ? numbers.vec3(json, -max_scale, max_scale)
                                     : Vec3::Constant(numbers.number(json, -max_scale, max_scale));
  if (scale.cwiseAbs().minCoeff() < 1e-4) json.report("a scale of 0 leaves nothing");
  return scale;
}

}  // namespace

double copy_angle(const Radial& radial, int index, int count) {
  const bool whole_turn = std::abs(radial.angle) > 2 * pi - 1e-9;
  const int steps = whole_turn ? count : std::max(1, count - 1);
  return radial.start + radial.angle * index / steps;
}

bool ComponentReader::spend(const JsonReader& json) {
  ++numbers_.reading().components;
  if (!numbers_.spend(json, 10)) return false;
  if (numbers_.reading().components <= max_components) return true;
  json.report("more than " + std::to_string(max_components) + " components");
  return false;
}

void ComponentReader::bound_copies(const JsonReader& json,
                                   const std::vector<Component>& made) const {
  if (component_count(made) > max_components)
    json.report("more than " + std::to_string(max_components) + " components, copies counted");
}

std::vector<Component> ComponentReader::read(const JsonReader& list) {
  std::vector<Component> components;
  for (const auto& element : list.elements(max_components)) read_into(components, element);
  std::set<std::string> names;
  for (const auto& component : components)
    if (!names.insert(component.name).second)
      list.report("two components are called \"" + component.name + "\"");
  bound_copies(list, components);
  return components;
}

void ComponentReader::read_into(std::vector<Component>& list, const JsonReader& json) {
  if (numbers_.failed()) return;
  const auto copies = numbers_.scope() && json.is_object() ? copying(json) : std::nullopt;
  if (!copies) {
    if (auto component = read_one(json)) list.push_back(*std::move(component));
    return;
  }
  const int count = numbers_.whole(copies->settings["count"], 1, max_count);
  const Numbers::Used around = std::exchange(numbers_.used, {});
  read_copied(list, json, copies->operation, count);
  // The j of the copies is the i around them.
  numbers_.used = {around.i || numbers_.used.j, around.j};
}

void ComponentReader::read_copied(std::vector<Component>& list, const JsonReader& json,
                                  std::size_t operation, int count) {
  const std::size_t components_before = numbers_.reading().components;
  std::optional<Component> first;
  {
    const CopyIndex bound(*numbers_.scope(), 0, count);
    first = read_one(json);
  }
  if (numbers_.used.i) {
    numbers_.reading().components = components_before;  // that one was only a look
    read_copies(list, json, operation, count);
  } else if (first) {
    list.push_back(*std::move(first));
  }
}

void ComponentReader::read_copies(std::vector<Component>& list, const JsonReader& json,
                                  std::size_t operation, int count) {
  const auto operations = json["operations"].elements(max_operations);
  for (std::size_t k = 0; k < operation; ++k)
    if (!operations[k]["cut"].exists())
      operations[operation].report(
          "copies that differ (they say \"i\") must be made by the first operation after cuts");
  std::vector<Component> copies;
  for (int i = 0; i < count && !numbers_.failed(); ++i) {
    const CopyIndex bound(*numbers_.scope(), i, count);
    if (auto copy = read_copy(json, operation, i, count)) copies.push_back(*std::move(copy));
  }
  if (copies.empty()) return;
  // What acts on all copies together needs them in a group.
  Component all;
  all.name = name(json["name"]);
  for (auto& copy : copies) {
    all.operations = std::exchange(copy.operations, {});
    const auto is_cut = [](const Operation& o) { return std::holds_alternative<Cut>(o); };
    const auto rest = std::stable_partition(all.operations.begin(), all.operations.end(), is_cut);
    copy.operations.assign(all.operations.begin(), rest);
    all.operations.erase(all.operations.begin(), rest);
  }
  if (all.operations.empty()) {
    list.insert(list.end(), std::make_move_iterator(copies.begin()),
                std::make_move_iterator(copies.end()));
    return;
  }
  for (auto& copy : copies) copy.name = copy.name.substr(all.name.size() + 1);
  all.solid = Group{std::move(copies)};
  list.push_back(std::move(all));
}

std::optional<Component> ComponentReader::read_copy(const JsonReader& json, std::size_t operation,
                                                    int index, int count) {
  auto component = read_one(json, operation);
  if (!component) return std::nullopt;
  const auto made =
      read_operation(json["operations"].elements(max_operations)[operation], numbers_);
  place_copy(*component, made, index, count);
  if (component->at.cwiseAbs().maxCoeff() > greatest_length)
    json["operations"].report("copy " + std::to_string(index) + " is more than " +
                              format_number(greatest_length) + " m away");
  component->name += "-" + std::to_string(index);
  return component;
}

void ComponentReader::allow_keys(const JsonReader& json) const {
  if (!json.is_object()) return json.report("expected a component, an object");
  std::vector<std::string> known = {"name",  "label",  "material", "operations",
                                    "scale", "rotate", "at",       "group"};
  for (auto& key : solid_keys()) known.push_back(std::move(key));
  if (numbers_.scope())
    for (const char* key : {"when", "use", "with", "materials"}) known.emplace_back(key);
  for (const auto& [key, ignored] : json.members()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    if (key == "when" || key == "use" || key == "with")
      return json.report("\"" + key + "\" belongs in recipes; this program is concrete");
    const std::string close = closest_name(key, known);
    return json.report(
        "unknown key \"" + key + "\"" +
        (close.empty() ? "; known are " + join(known, ", ") : "; did you mean \"" + close + "\"?"));
  }
}

std::string ComponentReader::name(const JsonReader& json) const {
  // Copies of a recipe's component have numbers after its name.
  const std::string text = json.text(numbers_.scope() ? 64 : 80);
  if (json.exists() && !is_name(text)) json.report("a name has letters, digits, - and _ only");
  return text;
}

std::string ComponentReader::material(const JsonReader& json) const {
  const std::string wanted = numbers_.word(json, "");
  if (wanted.empty()) return "";
  const auto found = materials_.find(wanted);
  if (found != materials_.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [from, ignored] : materials_) known.push_back(from);
  const std::string close = closest_name(wanted, known);
  json.report("no material \"" + wanted + "\"" +
              (close.empty()
                   ? (known.empty() ? "; there are none" : "; there are " + join(known, ", "))
                   : "; did you mean \"" + close + "\"?"));
  return "";
}

std::optional<Component> ComponentReader::read_one(const JsonReader& json,
                                                   std::optional<std::size_t> left_out) {
  if (!spend(json)) return std::nullopt;
  allow_keys(json);
  if (numbers_.failed()) return std::nullopt;
  if (json["when"].exists() && numbers_.number(json["when"], -1e9, 1e9) == 0.0) {
    --numbers_.reading().components;
    return std::nullopt;
  }
  Component component;
  component.name = name(json["name"]);
  component.label = numbers_.word(json["label"], "");
  component.solid = solid(json);
  // What is used has materials of its own, which the reader of `use` replaces.
  if (!json["use"].exists()) component.material = material(json["material"]);
  const auto operations = json["operations"].elements_or_none(max_operations);
  for (std::size_t k = 0; k < operations.size(); ++k)
    if (k != left_out) component.operations.push_back(read_operation(operations[k], numbers_));
  component.scale = read_scale(json["scale"], numbers_);
  if (json["rotate"].exists()) {
    const Vec3 turn = numbers_.vec3(json["rotate"], -max_degrees, max_degrees);
    component.rotate = turn.unaryExpr([](double angle) { return radians(angle); });
  }
  if (json["at"].exists())
    component.at = numbers_.vec3(json["at"], -greatest_length, greatest_length);
  bound_copies(json["operations"], {component});
  if (numbers_.failed()) return std::nullopt;
  return component;
}

Solid ComponentReader::solid(const JsonReader& json) {
  std::vector<std::string> keys = solid_keys(), found;
  keys.emplace_back("group");
  if (numbers_.scope()) keys.emplace_back("use");
  for (const auto& key : keys)
    if (json[key].exists()) found.push_back(key);
  if (found.size() != 1) {
    json.report(
        (found.empty() ? "has no solid" : "has more than one solid (" + join(found, ", ") + ")") +
        std::string("; expected exactly one of ") + join(keys, ", "));
    return Box{};
  }
  const std::string& key = found.front();
  for (const char* extra : {"with", "materials"})
    if (key != "use" && json[extra].exists()) json[extra].report("belongs to \"use\" only");
  if (key == "use") return use_(json, numbers_);
  if (key != "group") return read_solid(key, json[key], numbers_);
  json[key].allow_only({"components"});
  return Group{read(json[key]["components"])};
}

}  // namespace roomgen::shape::detail
