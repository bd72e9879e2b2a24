#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "arguments.h"
#include "check_report.h"
#include "explain.h"
#include "roomgen/base/file.h"
#include "roomgen/base/text.h"
#include "tools.h"

namespace roomgen::mcp {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

Result<ToolAnswer> preview(Workplace& place, const ToolCall& call) {
  std::vector<std::string> notices;
  auto room = look_at_room(place, call, notices);
  if (!room) return room.error();
  const std::string id = call.arguments["object"].get<std::string>();
  const Object* object = find_object(room->session.scene(), id);
  if (!object) return cli::explain_object(room->session.scene(), {}, id, {}).error();
  WantedPose pose;
  const Json& position = call.arguments["position"];
  pose.position = {position[0].get<double>(), position[1].get<double>()};
  pose.yaw = call.arguments.contains("yaw_deg") ? call.arguments["yaw_deg"].get<double>() * degree : object->yaw;
  pose.on = call.arguments.value("on", "");
  const auto result = room->session.preview(id, pose);
  if (!result) return result.error();
  return text_answer(text_of(cli::preview_lines(*result)), cli::preview_json(*result));
}

SceneReport examined(OpenedRoom& room) {
  return examine(room.session.scene(), room.session.models(), KindTable::built_in());
}

Result<ToolAnswer> check(Workplace& place, const ToolCall& call) {
  std::vector<std::string> notices;
  auto room = look_at_room(place, call, notices);
  if (!room) return room.error();
  const Scene& scene = room->session.scene();
  const SceneReport report = examined(*room);
  std::vector<std::string> lines = {cli::check_headline(scene, report)};
  for (const auto& line : cli::check_lines(report)) lines.push_back(line);
  Json data = cli::check_json(scene, report);
  data.erase("format");
  data["valid"] = report.violations.empty();
  data["not_held"] = Json::array();
  for (const auto& verdict : report.relations)
    if (!verdict.judgement.held) data["not_held"].push_back(verdict.object + " | " + to_text(verdict.relation));
  data["asked"] = scene.requirements.size();
  data["met"] = std::count_if(scene.requirements.begin(), scene.requirements.end(),
                              [](const RequirementVerdict& verdict) { return verdict.met(); });
  data["not_met"] = cli::unmet(scene);
  for (const auto& clause : cli::unmet(scene)) lines.push_back("  not met: " + clause);
  lines.insert(lines.end(), notices.begin(), notices.end());
  return text_answer(text_of(lines), std::move(data));
}

Result<ToolAnswer> explain(Workplace& place, const ToolCall& call) {
  std::vector<std::string> notices;
  auto room = look_at_room(place, call, notices);
  if (!room) return room.error();
  const Scene& scene = room->session.scene();
  if (!call.arguments.contains("object")) {
    auto all = cli::explain_scene(scene);
    return text_answer(text_of(all.lines), std::move(all.data));
  }
  const std::string id = call.arguments["object"].get<std::string>();
  auto one = cli::explain_object(scene, examined(*room), id, cli::traced(room->scene_file, id));
  if (!one) return one.error();
  return text_answer(text_of(one->lines), std::move(one->data));
}

Result<ToolAnswer> render(Workplace& place, const ToolCall& call) {
  std::vector<std::string> notices;
  auto room = look_at_room(place, call, notices);
  if (!room) return room.error();
  const std::string view = call.arguments.value("view", "marks");
  const int pixels = call.arguments.value("pixels", 512);
  const auto png = draw(place, room->session.scene(), room->session.models(), view, pixels);
  if (!png) return png.error();
  std::string text = room->name + ", " + view;
  if (call.arguments.contains("file")) {
    const auto file = new_file(place, call.arguments["file"].get<std::string>(), ".png");
    if (!file) return file.error();
    if (auto status = write_file(*file, *png); !status) return status.error();
    text += "; written to " + place.root.name_of(*file);
  }
  ToolAnswer answer = text_answer(text);
  add_picture(answer, *png);
  return answer;
}

}  // namespace

Tool preview_tool(Workplace& place) {
  return [&place](const ToolCall& call) { return preview(place, call); };
}

Tool check_tool(Workplace& place) {
  return [&place](const ToolCall& call) { return check(place, call); };
}

Tool explain_tool(Workplace& place) {
  return [&place](const ToolCall& call) { return explain(place, call); };
}

Tool render_tool(Workplace& place) {
  return [&place](const ToolCall& call) { return render(place, call); };
}

}  // namespace roomgen::mcp
