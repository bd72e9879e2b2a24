#include <nlohmann/json.hpp>

#include "arguments.h"
#include "room_files.h"
#include "roomgen/base/file.h"
#include "roomgen/export/exporter.h"
#include "tools.h"

namespace roomgen::mcp {

namespace {

}  // namespace

Result<ToolAnswer> export_room(Workplace& place, const ToolCall& call) {
  std::vector<std::string> notices;
  auto room = look_at_room(place, call, notices);
  if (!room) return room.error();
  const auto file = new_file(place, call.arguments["file"].get<std::string>(), ".glb");
  if (!file) return file.error();
  const Scene& scene = room->session.scene();
  const auto bytes = make_glb(scene, room->session.models(), cli::export_options());
  if (!bytes) return bytes.error();
  if (auto status = write_file(*file, *bytes); !status) return status.error();
  const std::string name = place.root.name_of(*file), credits = attribution_line(scene);
  std::vector<std::string> lines = {name + ": " + std::to_string(bytes->size()) + " bytes"};
  if (!credits.empty()) lines.push_back(credits);
  return text_answer(text_of(lines), {{"file", name}, {"bytes", bytes->size()}, {"attribution", credits}});
}

}  // namespace roomgen::mcp
