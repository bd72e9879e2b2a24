#include <nlohmann/json.hpp>

#include "roomgen/import/import.h"
#include "roomgen/edit/operation.h"
#include "roomgen/edit_reader/understand.h"
#include "tools.h"

namespace roomgen::mcp {

namespace {

const char* const asker = "agent";

Result<std::vector<edit::Operation>> operations_of(const ToolCall& call, const Session& session,
                                                   std::vector<std::string>& notices) {
  const bool has_sentence = call.arguments.contains("change");
  if (has_sentence == call.arguments.contains("operations"))
    return Error{Error::Kind::invalid_input, "edit: give either change or operations"};
  if (!has_sentence) return edit::operations_from_json(call.arguments["operations"], "/operations");
  auto understood = understand(session, call.arguments["change"].get<std::string>());
  if (!understood) return understood.error();
  for (const auto& remark : understood->remarks) notices.push_back(cli::remark_line(remark));
  return std::move(understood->operations);
}

void write_followers(Workplace& place, OpenedRoom& room, std::vector<std::string>& notices) {
  cli::PictureDrawer* drawer = place.keeps_pictures ? &place.drawer : nullptr;
  const auto tell = [&](const std::string& notice) { notices.push_back(notice); };
  // The change is in the journal already: it is done, whatever becomes of the files that follow.
  if (auto status = cli::write_room(room.scene_file, room.session, drawer, kept_pixels, tell); !status)
    notices.push_back(status.error().message);
}

ToolAnswer answer_of(Workplace& place, OpenedRoom& room, const ToolCall& call, std::vector<std::string> lines,
                     const std::vector<std::string>& notices, Json data) {
  lines.insert(lines.end(), notices.begin(), notices.end());
  if (!notices.empty()) data["notices"] = notices;
  ToolAnswer answer = text_answer(text_of(lines), std::move(data));
  add_wanted_picture(place, room.session.scene(), room.session.models(), call, answer);
  return answer;
}

ToolAnswer understood(const Json& operations) {
  return text_answer("Nothing was changed. This is what was understood:\n" + operations.dump(2),
                     {{"operations", operations}});
}

using Step = Result<std::size_t> (Session::*)(std::size_t, const std::string&);

Result<ToolAnswer> take_steps(Workplace& place, const ToolCall& call, Step step, const std::string& name) {
  std::vector<std::string> notices;
  auto room = open_room(place, call.arguments["room"].get<std::string>(), notices, {});
  if (!room) return room.error();
  const Scene before = room->session.scene();
  const auto taken = (room->session.*step)(call.arguments.value("steps", std::size_t{1}), asker);
  if (!taken) return taken.error();
  if (*taken == 0) return Error{Error::Kind::not_found, "there is nothing to " + name};
  write_followers(place, *room, notices);
  auto changes = differences(before, room->session.scene());
  Json data = {{"steps", *taken}, {"changes", changes}};
  return answer_of(place, *room, call, std::move(changes), notices, std::move(data));
}

}  // namespace

Result<ToolAnswer> edit_room(Workplace& place, const ToolCall& call) {
  std::vector<std::string> notices;
  const bool dry_run = call.arguments.value("dry_run", false);
  auto room = open_room(place, call.arguments["room"].get<std::string>(), notices,
                        {.look_only = dry_run, .repair = call.arguments.value("make_way", true), .cancel = call.cancel});
  if (!room) return room.error();
  const auto operations = operations_of(call, room->session, notices);
  if (!operations) return operations.error();
  const Json json = cli::operations_json(*operations);
  if (dry_run) return understood(json);
  const auto report = room->session.apply(*operations, {call.arguments.value("change", json.dump()), asker});
  if (!report) return report.error();
  write_followers(place, *room, notices);
  Json data = cli::report_json(*report);
  data["operations"] = json;
  return answer_of(place, *room, call, cli::report_lines(*report), notices, std::move(data));
}

Result<ToolAnswer> tell_history(Workplace& place, const ToolCall& call) {
  std::vector<std::string> notices;
  const auto room = look_at_room(place, call, notices);
  if (!room) return room.error();
  const auto state = [&](const char* key) -> std::optional<std::size_t> {
    if (!call.arguments.contains(key)) return std::nullopt;
    return call.arguments[key].get<std::size_t>();
  };
  if (state("from") || state("to")) {
    const auto lines = room->session.diff(state("from"), state("to"));
    if (!lines) return lines.error();
    return text_answer(text_of(*lines), {{"differences", *lines}});
  }
  const auto last = call.arguments.value("last", std::size_t{50});
  auto lines = cli::history_lines(room->session);
  const Json all = cli::history_json(room->session);
  const std::size_t earlier = all.size() > last ? all.size() - last : 0;
  lines.erase(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(earlier));
  Json data = {{"branch", room->session.current_branch()},
               {"branches", room->session.branches()},
               {"entries", Json::array()},
               {"earlier", earlier}};
  for (std::size_t i = earlier; i < all.size(); ++i) data["entries"].push_back(all[i]);
  return text_answer(text_of(lines), std::move(data));
}

Result<ToolAnswer> go_to_branch(Workplace& place, const ToolCall& call) {
  std::vector<std::string> notices;
  auto room = open_room(place, call.arguments["room"].get<std::string>(), notices, {});
  if (!room) return room.error();
  std::optional<std::size_t> at;
  if (call.arguments.contains("at")) at = call.arguments["at"].get<std::size_t>();
  const Scene before = room->session.scene();
  if (auto status = room->session.branch(call.arguments["name"].get<std::string>(), at, asker); !status)
    return status.error();
  write_followers(place, *room, notices);
  auto changes = differences(before, room->session.scene());
  Json data = {{"branch", room->session.current_branch()}, {"branches", room->session.branches()}, {"changes", changes}};
  changes.insert(changes.begin(), "on branch " + room->session.current_branch());
  return answer_of(place, *room, call, std::move(changes), notices, std::move(data));
}

Result<ToolAnswer> import_poses(Workplace& place, const ToolCall& call) {
  std::vector<std::string> notices;
  const std::string name = call.arguments["file"].get<std::string>();
  const auto file = place.root.find(name);
  if (!file) return file.error();
  const auto nodes = read_glb_nodes(*file);
  if (!nodes) return nodes.error();
  auto room = open_room(place, call.arguments["room"].get<std::string>(), notices, {});
  if (!room) return room.error();
  auto edits = room->session.compare(*nodes);
  if (!edits) return edits.error();
  notices.insert(notices.end(), edits->notes.begin(), edits->notes.end());
  auto operations = std::move(edits->operations);
  const bool removes = call.arguments.value("remove_missing", false);
  if (removes && !edits->missing.empty()) operations.insert(operations.begin(), edit::Remove{edits->missing, false});
  for (const auto& id : removes ? std::vector<std::string>() : edits->missing)
    notices.push_back("no node is called " + id + "; it stays");
  if (operations.empty())
    return answer_of(place, *room, call, {"nothing is different from the room"}, notices, {{"changes", Json::array()}});
  const auto report = room->session.apply(operations, {"import " + name, asker});
  if (!report) return report.error();
  write_followers(place, *room, notices);
  return answer_of(place, *room, call, cli::report_lines(*report), notices, cli::report_json(*report));
}

Result<ToolAnswer> undo_edits(Workplace& place, const ToolCall& call) {
  return take_steps(place, call, &Session::undo, "undo");
}

Result<ToolAnswer> redo_edits(Workplace& place, const ToolCall& call) {
  return take_steps(place, call, &Session::redo, "redo");
}

}  // namespace roomgen::mcp
