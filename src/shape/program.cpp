#include "roomgen/shape/program.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "component_reader.h"
#include "document.h"
#include "solid_json.h"

namespace roomgen::shape {

namespace {

using namespace detail;

Json write_components(const std::vector<Component>& components);

Json write_component(const Component& component) {
  Json json = {{"name", component.name}};
  if (!component.label.empty()) json["label"] = component.label;
  if (const auto* group = std::get_if<Group>(&component.solid)) {
    json["group"] = {{"components", write_components(group->components)}};
  } else {
    auto [key, solid] = write_solid(component.solid);
    json[key] = std::move(solid);
  }
  for (const auto& operation : component.operations)
    json["operations"].push_back(write_operation(operation));
  if (to_json(component.scale) != to_json(Vec3(Vec3::Ones())))
    json["scale"] = to_json(component.scale);
  const Vec3 turn = component.rotate.unaryExpr([](double angle) { return degrees(angle); });
  if (to_json(turn) != to_json(Vec3(Vec3::Zero()))) json["rotate"] = to_json(turn);
  if (to_json(component.at) != to_json(Vec3(Vec3::Zero()))) json["at"] = to_json(component.at);
  if (!component.material.empty()) json["material"] = component.material;
  return json;
}

Json write_components(const std::vector<Component>& components) {
  Json json = Json::array();
  for (const auto& component : components) json.push_back(write_component(component));
  return json;
}

std::size_t copies(const Component& component) {
  std::size_t made = 1;
  for (const auto& operation : component.operations) {
    std::size_t times = 1;
    if (std::holds_alternative<Mirror>(operation)) times = 2;
    if (const auto* array = std::get_if<Array>(&operation)) times = array->count;
    if (const auto* radial = std::get_if<Radial>(&operation)) times = radial->count;
    made = std::min(made * times, max_components + 1);
  }
  return made;
}

}  // namespace

std::vector<std::string> pattern_names() {
  return {"none",   "grain",   "weave",  "marble",  "leather", "brushed",
          "wicker", "stripes", "checks", "speckle", "rug",     "tiles"};
}

std::vector<std::string> picture_themes() {
  return {"screen", "mirror", "clock", "plain"};
}

std::size_t component_count(const std::vector<Component>& components) {
  std::size_t count = 0;
  for (const auto& component : components) {
    const auto* group = std::get_if<Group>(&component.solid);
    const std::size_t each = group ? component_count(group->components) : 1;
    // Far above the limit; beyond it only "more" matters.
    count = std::min<std::size_t>(count + each * copies(component), 1u << 30);
  }
  return count;
}

Result<Program> read_program(const Json& json, const std::string& source) {
  JsonReader::Problems problems(source);
  const JsonReader root(json, problems);
  Reading reading;
  const Numbers numbers(nullptr, reading, problems);
  check_head(root, numbers);
  if (problems.first()) return *problems.first();
  for (const char* key : {"parameters", "let"})
    if (root[key].exists())
      root.report(std::string("a recipe (it has \"") + key + "\"), not a concrete program");
  root.allow_only({"format", "version", "name", "about", "materials", "components", "connections"});
  Program program;
  program.name = root["name"].text_or("", 200);
  program.about = root["about"].text_or("", 2000);
  program.materials = read_surfaces(root["materials"], numbers);
  if (problems.first()) return *problems.first();
  ComponentReader reader(numbers, same_names(program.materials), nullptr);
  program.components = reader.read(root["components"]);
  if (problems.first()) return *problems.first();
  program.connections = read_connections(root, program.components, numbers);
  if (problems.first()) return *problems.first();
  return program;
}

Json write_program(const Program& program) {
  Json json;
  json["format"] = "roomgen-shape";
  json["version"] = 1;
  json["name"] = program.name;
  if (!program.about.empty()) json["about"] = program.about;
  if (!program.materials.empty()) json["materials"] = Json::object();
  for (const auto& surface : program.materials)
    json["materials"][surface.name] = write_surface(surface);
  json["components"] = write_components(program.components);
  if (!program.connections.empty()) json["connections"] = program.connections;
  return json;
}

}  // namespace roomgen::shape
