#include <nlohmann/json.hpp>

#include "roomgen/base/text.h"
#include "tools.h"

namespace roomgen::mcp {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_rooms = 200, most_of_wish = 200;

// All that roomgen writes into a room's folder.
constexpr const char* own_files[] = {
    "scene.glb", "ATTRIBUTION.md", "plan.json",   "trace.jsonl", "top.png",       "iso.png",
    "eye.png",   "program.json",   "rounds.json", "marks",       "scene.journal", "scene.json"};

}  // namespace

Result<ToolAnswer> list_rooms(Workplace& place, const ToolCall&) {
  std::vector<std::string> lines;
  const auto rooms = place.root.rooms(most_rooms);
  for (const auto& name : rooms) {
    const auto file = place.root.find_scene(name);
    const auto scene = file ? read_scene(*file) : Result<Scene>(file.error());
    const std::string what = scene ? scene->prompt : scene.error().message;
    lines.push_back(name + ": " + shortened(what, most_of_wish));
  }
  return text_answer(lines.empty() ? "there is no room yet" : text_of(lines), {{"rooms", rooms}});
}

Result<ToolAnswer> delete_room(Workplace& place, const ToolCall& call) {
  std::vector<std::string> notices;
  // Nobody else edits it meanwhile.
  const auto room = open_room(place, call.arguments["room"].get<std::string>(), notices, {});
  if (!room) return room.error();
  const fs::path folder = room->scene_file.parent_path();
  std::error_code code;
  for (const char* name : own_files) {
    fs::remove_all(folder / name, code);
    if (code) return Error{Error::Kind::io, room->name + "/" + name + ": " + code.message()};
  }
  const bool is_gone = folder != place.root.path() && fs::remove(folder, code);
  const std::string rest = is_gone ? "" : "; other files are still in its folder";
  return text_answer(room->name + ": deleted" + rest, {{"room", room->name}});
}

}  // namespace roomgen::mcp
