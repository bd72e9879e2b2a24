#include <nlohmann/json.hpp>
#include <numbers>

#include "arguments.h"
#include "check_report.h"
#include "explain.h"
#include "page.h"
#include "roomgen/base/file.h"
#include "roomgen/base/text.h"
#include "roomgen/render/pictures.h"
#include "tools.h"

namespace roomgen::mcp {

namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr std::size_t most_of_prompt = 2'000, most_of_trace = 20'000;  // bytes
constexpr int reviewed_pixels = 768;

std::size_t skipped(const ToolCall& call) { return call.arguments.value("skip", std::size_t{0}); }

// What was tried for one thing may be very much; the file has it all.
void shorten_trace(cli::Explanation& one) {
  if (!one.data.contains("placed") || json_line(one.data["placed"]).size() <= most_of_trace) return;
  one.data["placed"].erase("attempts");
  one.lines.push_back("  what was tried for it is too long for an answer: trace.jsonl has it");
}

SceneReport examined(OpenedRoom& room) {
  return examine(room.session.scene(), room.session.models(), KindTable::built_in());
}

Vec3 point_of(const Json& json) {
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

Result<std::string> photograph(Workplace& place, OpenedRoom& room, const Json& json, int pixels) {
  const auto camera = pinhole_camera(point_of(json["eye"]), point_of(json["target"]),
                                     json.value("angle_deg", 70.0) * degree, pixels, pixels * 3 / 4);
  if (!camera) return with_context(camera.error(), "/camera");
  const Scene& scene = room.session.scene();
  if (!is_indoors(scene, camera->eye->head<2>()))
    return Error{Error::Kind::invalid_input,
                 "/camera/eye: it is in a wall or outdoors; put it into the room"};
  const auto renderer = place.drawer.renderer();
  if (!renderer) return renderer.error();
  const auto layers = (*renderer)->layers(scene, room.session.models(), {*camera, View::Kind::eye});
  if (!layers) return layers.error();
  return encode_png(layers->color);
}

// The ledger, as models that look at rooms are shown it.
std::vector<std::string> review_lines(const Scene& scene) {
  std::vector<std::string> lines = {"The wish: " + shortened(scene.prompt, most_of_prompt)};
  for (const auto& one : scene.requirements) lines.push_back(told(one));
  for (const auto& missing : scene.unplaced)
    lines.push_back("left out: " + missing.id + ": " + missing.reason);
  return lines;
}

}  // namespace

Result<ToolAnswer> preview_pose(Workplace& place, const ToolCall& call) {
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

Result<ToolAnswer> check_room(Workplace& place, const ToolCall& call) {
  std::vector<std::string> notices;
  auto room = look_at_room(place, call, notices);
  if (!room) return room.error();
  const Scene& scene = room->session.scene();
  const SceneReport report = examined(*room);
  Report found{cli::check_json(scene, report), {"violations", "not_held", "not_met"},
               {cli::check_headline(scene, report)}, cli::check_lines(scene, report)};
  found.data.erase("format");
  found.head.insert(found.head.end(), notices.begin(), notices.end());
  return page_of(found, skipped(call));
}

Result<ToolAnswer> explain_room(Workplace& place, const ToolCall& call) {
  std::vector<std::string> notices;
  auto room = look_at_room(place, call, notices);
  if (!room) return room.error();
  const Scene& scene = room->session.scene();
  if (!call.arguments.contains("object")) {
    auto all = cli::explain_scene(scene);
    all.data["prompt"] = shortened(scene.prompt, most_of_prompt);
    const Report found{std::move(all.data),
                       {"rooms", "objects", "requirements", "not_understood", "left_out"},
                       {},
                       std::move(all.lines)};
    return page_of(found, skipped(call));
  }
  const std::string id = call.arguments["object"].get<std::string>();
  auto one = cli::explain_object(scene, examined(*room), id, cli::traced(room->scene_file, id));
  if (!one) return one.error();
  shorten_trace(*one);
  return text_answer(text_of(one->lines), std::move(one->data));
}

Result<ToolAnswer> review_room(Workplace& place, const ToolCall& call) {
  std::vector<std::string> notices;
  auto room = look_at_room(place, call, notices);
  if (!room) return room.error();
  const Scene& scene = room->session.scene();
  ToolAnswer answer = text_answer(text_of(review_lines(scene)));
  for (const char* view : {"marks", "iso", "eye", "elevation"}) {
    const auto png = draw(place, scene, room->session.models(), view, reviewed_pixels);
    if (!png) return png.error();
    add_picture(answer, *png);
  }
  return answer;
}

Result<ToolAnswer> render_room(Workplace& place, const ToolCall& call) {
  std::vector<std::string> notices;
  auto room = look_at_room(place, call, notices);
  if (!room) return room.error();
  const std::string view = call.arguments.value("view", "marks");
  const int pixels = call.arguments.value("pixels", 512);
  const bool has_camera = call.arguments.contains("camera");
  const auto png = has_camera ? photograph(place, *room, call.arguments["camera"], pixels)
                              : draw(place, room->session.scene(), room->session.models(), view, pixels);
  if (!png) return png.error();
  std::string text = room->name + ", " + (has_camera ? "from the camera" : view);
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

}  // namespace roomgen::mcp
