#include "roomgen/generate/generate.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t max_name_words = 6;
constexpr std::size_t max_name_bytes = 60;

// What only an earlier run of ours leaves: a scene or plan that says so at its beginning.
bool is_earlier_output(const fs::path& folder) {
  for (const auto* name : {"scene.json", "plan.json"}) {
    const auto text = read_file(folder / name);
    if (text && text->substr(0, 200).find("\"roomgen-") != std::string::npos) return true;
  }
  return false;
}

// All that a room's folder may hold.
bool is_part_of_room(const fs::path& relative) {
  static const std::set<std::string> names = {"scene.json", "plan.json", "trace.jsonl", "scene.glb",
                                              "ATTRIBUTION.md", "top.png", "iso.png", "eye.png",
                                              "marks"};
  const std::string path = relative.generic_string();
  return names.count(path) > 0 || path.starts_with("marks/step-") || path.starts_with("marks/shown-");
}

// The last line of the trace: what the improvement at the end moved.
Json finish_json(const std::vector<Move>& moved) {
  Json json;
  for (const auto& move : moved) json["moved"].push_back(to_json(move));
  return json;
}

}  // namespace

Result<OutputFolder> open_room_folder(const fs::path& folder, bool force) {
  std::error_code code;
  const bool is_empty = !fs::is_directory(folder, code) || fs::is_empty(folder, code);
  const bool is_earlier = !is_empty && is_earlier_output(folder);
  if (!is_empty && !is_earlier && !force)
    return Error{Error::Kind::io, folder.string() +
                                      ": is not empty and no earlier output of roomgen; choose "
                                      "another folder or --force"};
  return OutputFolder::open(folder, is_earlier ? is_part_of_room : OutputFolder::Ours());
}

bool holds_whole_scene(const fs::path& scene_file) {
  const auto scene = read_scene(scene_file);
  return scene && !scene->incomplete;
}

std::string folder_name(const std::string& prompt) {
  auto pieces = words(prompt);
  pieces.resize(std::min(pieces.size(), max_name_words));
  std::string name;
  for (char c : join(pieces, "-"))
    if (static_cast<unsigned char>(c) < 128 && name.size() < max_name_bytes) name += c;
  return name.empty() ? "room" : name;
}

Status write_documents(const OutputFolder& folder, const Json& plan, const Generation& generation) {
  std::string trace;
  for (const auto& round : generation.choices) trace += json_line(to_json(round)) + "\n";
  for (const auto& step : generation.trace) trace += json_line(to_json(step)) + "\n";
  if (!generation.moved.empty()) trace += json_line(finish_json(generation.moved)) + "\n";
  if (auto s = folder.write("plan.json", dump_json(plan)); !s) return s;
  if (auto s = folder.write("trace.jsonl", trace); !s) return s;
  return folder.write("scene.json", dump_json(to_json(generation.scene)));
}

}  // namespace roomgen
