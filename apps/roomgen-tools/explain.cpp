#include "explain.h"

#include <algorithm>
#include <numbers>
#include <sstream>

#include "roomgen/base/file.h"
#include "roomgen/base/text.h"

namespace roomgen::cli {

namespace {

Json numbers_json(const Vec3& v) { return {rounded(v.x()), rounded(v.y()), rounded(v.z())}; }

double yaw_degrees(const Object& object) { return rounded(object.yaw * 180.0 / std::numbers::pi, 2); }

Json thing_json(const Object& object) {
  Json json = {{"id", object.id}, {"category", object.category}};
  if (!object.description.empty()) json["description"] = object.description;
  json["size"] = numbers_json(object.size);
  json["position"] = numbers_json(object.position);
  json["yaw_deg"] = yaw_degrees(object);
  if (object.mount != Mount::floor) json["mount"] = name(object.mount);
  if (!object.on.empty()) json["on"] = object.on;
  if (!object.room.empty()) json["room"] = object.room;
  if (object.locked) json["locked"] = true;
  return json;
}

std::string thing_line(const Object& object) {
  const auto metres = [](double value) { return format_number(value, 2); };
  return object.id + ": " + (object.description.empty() ? object.category : object.description) + ", " +
         size_text(object.size) + " m, at " + metres(object.position.x()) + ", " + metres(object.position.y()) +
         (object.position.z() > 0.005 ? ", " + metres(object.position.z()) + " up" : "") + ", turned by " +
         format_number(yaw_degrees(object), 1) + " degrees" + (object.on.empty() ? "" : ", on " + object.on) +
         (object.locked ? ", locked" : "");
}

Json opening_json(const Opening& opening) {
  return {{"id", opening.id},
          {"type", name(opening.type)},
          {"wall", opening.wall},
          {"from", rounded(opening.from)},
          {"to", rounded(opening.to)}};
}

Json outline_json(const Room& room) {
  Json json = {{"type", room.type}, {"polygon", Json::array()}, {"height", room.height}, {"openings", Json::array()}};
  if (!room.id.empty()) json["id"] = room.id;
  for (const auto& point : room.polygon.points) json["polygon"].push_back({rounded(point.x()), rounded(point.y())});
  for (const auto& opening : room.openings) json["openings"].push_back(opening_json(opening));
  return json;
}

Json clause_json(const RequirementVerdict& verdict) {
  Json json = {{"clause", verdict.requirement.clause},
               {"source", name(verdict.requirement.source)},
               {"verdict", name(verdict.compliance)}};
  if (!verdict.reason.empty()) json["reason"] = verdict.reason;
  return json;
}

std::string clause_line(const RequirementVerdict& verdict) {
  return "  asked: " + told(verdict.requirement) + ": " + std::string(name(verdict.compliance)) +
         (verdict.reason.empty() ? "" : " (" + verdict.reason + ")");
}

Error no_such_object(const Scene& scene, const std::string& id) {
  std::vector<std::string> ids;
  for (const auto& object : scene.objects) ids.push_back(object.id);
  const std::string close = closest_name(id, ids);
  return {Error::Kind::not_found, "there is no \"" + shortened(id, 100) + "\" in the room" +
                                      (close.empty() ? "" : "; did you mean \"" + close + "\"?")};
}

bool is_about(const RequirementVerdict& verdict, const std::string& id) {
  const auto names_it = [&](const std::vector<std::string>& ids) { return std::count(ids.begin(), ids.end(), id) > 0; };
  return names_it(verdict.requirement.subjects) || names_it(verdict.requirement.targets);
}

void add_relations(const SceneReport& report, const std::string& id, Explanation& result) {
  result.data["relations"] = Json::array();
  for (const auto& verdict : report.relations) {
    if (verdict.object != id) continue;
    const std::string text = to_text(verdict.relation);
    result.data["relations"].push_back({{"relation", text}, {"held", verdict.judgement.held}});
    result.lines.push_back("  " + text + (verdict.judgement.held ? "" : " (does not hold)"));
  }
}

void add_loads(const Scene& scene, const std::string& id, Explanation& result) {
  Json carried = Json::array();
  for (const auto& object : scene.objects)
    if (object.on == id) {
      carried.push_back(object.id);
      result.lines.push_back("  carries " + object.id);
    }
  if (!carried.empty()) result.data["carries"] = carried;
}

// How the step that placed it went; only what people ask for is said in words.
void add_trace(const Json& step, Explanation& result) {
  result.data["placed"] = step;
  const Json attempts = step.value("attempts", Json::array());
  if (!attempts.is_array() || attempts.empty() || !attempts.back().is_object()) return;
  const Json& last = attempts.back();
  const auto number = [&](const char* key) { return last.value(key, Json(0)).dump(); };
  result.lines.push_back("  placed when the room was made: " + number("feasible") + " of " + number("candidates") +
                         " places tried were possible");
}

}  // namespace

Explanation explain_scene(const Scene& scene) {
  Explanation result;
  Json& data = result.data;
  data["prompt"] = scene.prompt;
  for (const auto& room : rooms_of(scene)) {
    data["rooms"].push_back(outline_json(room));
    const Vec2 box = bounds(room.polygon).size();
    result.lines.push_back((room.id.empty() ? room.type : room.id) + ", " + format_number(box.x(), 2) + " x " +
                           format_number(box.y(), 2) + " m");
  }
  data["objects"] = Json::array();
  for (const auto& object : scene.objects) {
    data["objects"].push_back(thing_json(object));
    result.lines.push_back("  " + thing_line(object));
  }
  data["requirements"] = Json::array();
  for (const auto& verdict : scene.requirements) {
    data["requirements"].push_back(clause_json(verdict));
    result.lines.push_back(clause_line(verdict));
  }
  data["not_understood"] = Json::array();
  for (const auto& heard : scene.heard)
    if (heard.as == Heard::As::not_understood) {
      data["not_understood"].push_back(heard.text);
      result.lines.push_back("  not understood: \"" + heard.text + "\"");
    }
  data["left_out"] = Json::array();
  for (const auto& missing : scene.unplaced) {
    data["left_out"].push_back({{"id", missing.id}, {"reason", missing.reason}});
    result.lines.push_back("  left out: " + missing.id + ": " + missing.reason);
  }
  return result;
}

Result<Explanation> explain_object(const Scene& scene, const SceneReport& report, const std::string& id,
                                   const std::optional<Json>& trace_line) {
  const Object* object = find_object(scene, id);
  if (!object) return no_such_object(scene, id);
  Explanation result;
  result.data["object"] = thing_json(*object);
  result.lines.push_back(thing_line(*object));
  add_relations(report, id, result);
  add_loads(scene, id, result);
  result.data["requirements"] = Json::array();
  for (const auto& verdict : scene.requirements) {
    if (!is_about(verdict, id)) continue;
    result.data["requirements"].push_back(clause_json(verdict));
    result.lines.push_back(clause_line(verdict));
  }
  for (const auto& violation : report.violations)
    if (violation.object == id || violation.other == id)
      result.lines.push_back("  fault: " + std::string(name(violation.fault)));
  if (trace_line) add_trace(*trace_line, result);
  return result;
}

std::optional<Json> traced(const std::filesystem::path& scene_file, const std::string& id) {
  const auto text = read_file(scene_file.parent_path() / "trace.jsonl");
  if (!text) return std::nullopt;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) {
    const auto step = parse_json(line, "trace.jsonl");
    if (step && step->is_object() && step->value("object", Json()) == id) return *step;
  }
  return std::nullopt;
}

}  // namespace roomgen::cli
