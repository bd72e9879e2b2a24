#include "room_session.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

#include "models.h"
#include "roomgen/base/text.h"
#include "views.h"

namespace roomgen::cli {

namespace {

namespace fs = std::filesystem;

bool is_followed_by(const fs::path& scene_file, const char* name) {
  std::error_code code;
  return fs::exists(scene_file.parent_path() / name, code);
}

// Those of a room's files that follow scene.json: they go unless they are written anew.
bool shows_the_room(const fs::path& relative) {
  const std::string name = relative.generic_string();
  return name == "scene.glb" || name == "ATTRIBUTION.md" || name == "top.png" || name == "iso.png" || name == "eye.png";
}

// Meshes that were still to be read when the program was told to stop are missing.
Status check_not_stopped(const CancelToken& cancel) {
  if (!cancel.cancelled()) return {};
  return Error{Error::Kind::cancelled,
               "stopped; the change is kept in the journal, and the files follow with the next command"};
}

Status write_all_files(const fs::path& file, Session& session, PictureDrawer* drawer, int pixels,
                       const CancelToken& cancel) {
  if (auto status = check_not_stopped(cancel); !status) return status;
  const bool has_models = is_followed_by(file, "scene.glb"), has_pictures = is_followed_by(file, "top.png");
  if (file.filename() != "scene.json" || (!has_models && !has_pictures)) return session.save();
  auto folder = OutputFolder::open(file.parent_path(), shows_the_room);
  if (!folder) return folder.error();
  if (auto status = folder->write("scene.json", session.text()); !status) return status;
  if (auto status = write_model_files(*folder, session.scene(), session.models()); !status) return status;
  if (has_pictures && drawer) {
    auto renderer = drawer->renderer();
    if (!renderer) return renderer.error();
    if (auto status = write_pictures(*folder, session.scene(), session.models(), **renderer, pixels); !status)
      return status;
  }
  if (auto status = check_not_stopped(cancel); !status) return status;
  if (auto status = folder->commit(); !status) return status;
  session.mark_saved();
  return {};
}

Json item_json(const HistoryItem& item) {
  Json json = {{"branch", item.branch}, {"by", item.by}, {"asked", item.asked}};
  if (item.state == 0) return json;
  json["state"] = item.state;
  json["parent"] = item.parent;
  json["current"] = item.is_current;
  json["undone"] = item.is_undone;
  return json;
}

std::string item_line(const HistoryItem& item) {
  const std::string number = item.state > 0 ? std::to_string(item.state) : "";
  char start[16];
  std::snprintf(start, sizeof start, "%c %4s", item.is_current ? '*' : item.is_undone ? '-' : ' ', number.c_str());
  return std::string(start) + "  " + item.branch + "  " + item.by + ": " + item.asked;
}

}  // namespace

Result<Session> open_room(const fs::path& scene_file, const AssetLibrary& library, RoomAccess access) {
  const Tell tell = access.tell ? std::move(access.tell) : [](const std::string&) {};
  SessionOptions options;
  options.look_only = access.look_only;
  options.repair = access.repair;
  options.cancel = access.cancel;
  options.spare_models = written_models(scene_file);
  options.log = [tell](LogLevel, std::string_view message) { tell(std::string(message) + "; taken as a box"); };
  auto session = Session::open(scene_file, library, KindTable::built_in(), std::move(options));
  if (session)
    for (const auto& notice : session->notices()) tell(notice);
  return session;
}

Status write_room(const fs::path& scene_file, Session& session, PictureDrawer* drawer, int pixels, const Tell& tell,
                  const CancelToken& cancel) {
  std::error_code code;
  const fs::path whole = fs::absolute(scene_file, code);
  const Status status = code ? Status(Error{Error::Kind::io, scene_file.string() + ": " + code.message()})
                             : write_all_files(whole, session, drawer, pixels, cancel);
  if (status) return {};
  if (status.error().kind == Error::Kind::cancelled) return status;
  if (tell)
    tell(status.error().message + "; the change is kept in the journal, and scene.json follows with the next command");
  return session.save();
}

Result<std::vector<std::string>> pictures_for_model(const DesignerOptions& options,
                                                    PictureDrawer& drawer, Session& session,
                                                    std::initializer_list<const char*> views,
                                                    int pixels) {
  std::vector<std::string> pictures;
  const auto renderer = drawer.renderer();
  if (!renderer) return renderer.error();
  for (const auto& part : parts_of(session.scene()))
    for (const char* view : views) {
      const auto picture = (*renderer)->render(part, session.models(), view_named(view, pixels));
      if (!picture) return picture.error();
      auto encoded = encode_for(options, *picture);
      if (!encoded) return encoded.error();
      pictures.push_back(*std::move(encoded));
    }
  return pictures;
}

std::string remark_line(const std::string& remark) { return "taken for a remark: \"" + remark + "\""; }

Json operations_json(const std::vector<edit::Operation>& operations) {
  Json json = Json::array();
  for (const auto& operation : operations) json.push_back(edit::to_json(operation));
  return json;
}

Json report_json(const EditReport& report) {
  Json json = {{"state", report.state}, {"changes", report.changes}, {"added", report.added},
               {"repairs", Json::array()}, {"broken", report.broken}};
  for (const auto& move : report.repairs) json["repairs"].push_back(to_json(move));
  return json;
}

std::vector<std::string> report_lines(const EditReport& report) {
  std::vector<std::string> lines = report.changes;
  for (const auto& move : report.repairs)
    lines.push_back(move.object + " made way by " + format_number(move.distance(), 2) + " m");
  lines.insert(lines.end(), report.broken.begin(), report.broken.end());
  if (lines.empty()) lines.push_back("nothing is different: it was so already");
  return lines;
}

Json preview_json(const Preview& preview) {
  const Vec3& at = preview.object.position;
  Json json = {{"feasible", preview.feasible},
               {"position", {rounded(at.x()), rounded(at.y()), rounded(at.z())}},
               {"yaw_deg", rounded(preview.object.yaw * 180.0 / std::numbers::pi, 2)},
               {"nearest", rounded(preview.nearest, 3)},
               {"broken", preview.broken}};
  if (!preview.reason.empty()) json["reason"] = preview.reason;
  if (!preview.object.on.empty()) json["on"] = preview.object.on;
  return json;
}

std::vector<std::string> preview_lines(const Preview& preview) {
  std::vector<std::string> lines = {
      preview.feasible ? "possible; the nearest thing or wall is " + format_number(preview.nearest, 2) + " m away"
                       : "not possible: " + preview.reason};
  for (const auto& relation : preview.broken) lines.push_back("would break: " + relation);
  return lines;
}

Json history_json(const Session& session) {
  Json all = Json::array();
  for (const auto& item : session.history()) all.push_back(item_json(item));
  return all;
}

std::vector<std::string> history_lines(const Session& session) {
  std::vector<std::string> lines;
  for (const auto& item : session.history()) lines.push_back(item_line(item));
  return lines;
}

}  // namespace roomgen::cli
