#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "solid_json.h"

namespace roomgen::shape::detail {

namespace {

constexpr int max_count = static_cast<int>(max_components);

Cut read_cut(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"point", "normal"});
  Cut cut{numbers.vec3(json["point"], -greatest_length, greatest_length),
          numbers.vec3(json["normal"], -1e6, 1e6)};
  if (cut.normal.norm() < 1e-6) json["normal"].report("a normal of no length");
  return cut;
}

Mirror read_mirror(const JsonReader& json, const Numbers& numbers) {
  const std::string axis = numbers.word(json, "");
  if (axis != "x" && axis != "y") json.report("expected \"x\" or \"y\"");
  return {axis == "y" ? 1 : 0};
}

Array read_array(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"count", "step"});
  return {numbers.whole(json["count"], 1, max_count),
          numbers.vec3(json["step"], -greatest_length, greatest_length)};
}

Radial read_radial(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"count", "center", "angle", "start"});
  Radial radial;
  radial.count = numbers.whole(json["count"], 1, max_count);
  if (json["center"].exists())
    radial.center = numbers.vec2(json["center"], -greatest_length, greatest_length);
  radial.angle = numbers.angle_or(json["angle"], 360.0, -360.0, 360.0);
  radial.start = numbers.angle_or(json["start"], 0.0, -max_degrees, max_degrees);
  return radial;
}

Center read_center(const JsonReader& json) {
  const std::string axes = json.text(3);
  Center center;
  for (const char axis : axes) {
    bool* which = axis == 'x'   ? &center.x
                  : axis == 'y' ? &center.y
                  : axis == 'z' ? &center.z
                                : nullptr;
    if (!which || *which)
      json.report("expected axes, each once, as in \"xy\"");
    else
      *which = true;
  }
  if (axes.empty()) json.report("expected axes, as in \"xy\"");
  return center;
}

template <typename T>
T read_flag(const JsonReader& json) {
  if (!json.boolean_or(false)) json.report("expected true; leave the operation out otherwise");
  return {};
}

struct OperationWriter {
  Json operator()(const Cut& cut) const {
    return {{"cut", {{"point", to_json(cut.point)}, {"normal", to_json(cut.normal)}}}};
  }
  Json operator()(const Mirror& mirror) const { return {{"mirror", mirror.axis == 0 ? "x" : "y"}}; }
  Json operator()(const Array& array) const {
    return {{"array", {{"count", array.count}, {"step", to_json(array.step)}}}};
  }
  Json operator()(const Radial& radial) const {
    Json json = {{"count", radial.count}};
    if (to_json(radial.center) != to_json(Vec2(Vec2::Zero())))
      json["center"] = to_json(radial.center);
    if (file_degrees(radial.angle) != 360.0) json["angle"] = file_degrees(radial.angle);
    if (file_degrees(radial.start) != 0.0) json["start"] = file_degrees(radial.start);
    return {{"radial", json}};
  }
  Json operator()(const Center& center) const {
    return {{"center",
             std::string(center.x ? "x" : "") + (center.y ? "y" : "") + (center.z ? "z" : "")}};
  }
  Json operator()(const Ground&) const { return {{"ground", true}}; }
  Json operator()(const Join&) const { return {{"join", true}}; }
};

}  // namespace

Operation read_operation(const JsonReader& json, const Numbers& numbers) {
  json.allow_only({"cut", "mirror", "array", "radial", "center", "ground", "join"});
  const auto members = json.members();
  if (members.size() != 1) {
    if (json.is_object())
      json.report("expected exactly one of cut, mirror, array, radial, center, ground, join");
    return Ground{};
  }
  const auto& [key, value] = members.front();
  if (key == "cut") return read_cut(value, numbers);
  if (key == "mirror") return read_mirror(value, numbers);
  if (key == "array") return read_array(value, numbers);
  if (key == "radial") return read_radial(value, numbers);
  if (key == "center") return read_center(value);
  if (key == "ground") return read_flag<Ground>(value);
  return read_flag<Join>(value);
}

Json write_operation(const Operation& operation) {
  return std::visit(OperationWriter{}, operation);
}

}  // namespace roomgen::shape::detail
