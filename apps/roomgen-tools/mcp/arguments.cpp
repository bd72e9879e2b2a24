#include "arguments.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "options.h"
#include "roomgen/base/file.h"
#include "roomgen/base/text.h"

namespace roomgen::mcp {

namespace fs = std::filesystem;

namespace {

// An agent's file never takes the place of a room.
bool is_of_a_room(const fs::path& file) {
  const std::string name = file.filename().string();
  return name == "scene.json" || name == "scene.glb" || name == "plan.json";
}

// A .json of somebody else's is not written over, nor what is no picture or model in spite of its name.
bool may_be_replaced(const fs::path& file, const std::string& ending) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return true;
  std::string start(64, '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  if (ending == ".json") return start.find("\"roomgen-plan\"") != std::string::npos;
  return start.starts_with(ending == ".png" ? "\x89PNG" : "glTF");
}

}  // namespace

Result<cli::PlanWish> plan_wish(const Workplace& place, const Json& arguments) {
  cli::PlanWish wish;
  wish.prompt = arguments.value("prompt", "");
  wish.seed = arguments.value("seed", std::uint64_t{0});
  wish.size = arguments.value("size", "");
  if (!wish.size.empty())
    if (auto size = cli::parse_size(wish.size); !size) return with_context(size.error(), "/size");
  if (!arguments.contains("floor_plan")) return wish;
  const auto file = place.root.find(arguments["floor_plan"].get<std::string>());
  if (!file) return with_context(file.error(), "/floor_plan");
  wish.floor_plan = file->string();
  return wish;
}

Result<fs::path> new_room_folder(const Workplace& place, const Json& arguments) {
  const std::string path = arguments["folder"].get<std::string>();
  auto folder = place.root.find(path);
  if (!folder) return with_context(folder.error(), "/folder");
  if (*folder == place.root.path())
    return Error{Error::Kind::invalid_input, "/folder: name a folder below the root, such as \"bedroom\""};
  std::error_code code;
  if (fs::exists(*folder / "scene.json", code) && !arguments.value("replace", false))
    return Error{Error::Kind::invalid_input,
                 "\"" + path + "\" holds a room already; choose another folder, or set replace to true"};
  return folder;
}

std::vector<std::string> not_understood(const Scene& scene) {
  std::vector<std::string> texts;
  for (const auto& words : scene.heard)
    if (words.as == Heard::As::not_understood) texts.push_back(words.text);
  return texts;
}

Result<fs::path> new_file(const Workplace& place, const std::string& path, const std::string& ending) {
  auto file = place.root.find(path);
  if (!file) return file.error();
  if (lower(file->extension().string()) != ending)
    return Error{Error::Kind::invalid_input, "\"" + path + "\" does not end with " + ending};
  if (is_of_a_room(*file))
    return Error{Error::Kind::invalid_input, "\"" + path + "\" is a room's own file; choose another name"};
  if (!may_be_replaced(*file, ending))
    return Error{Error::Kind::invalid_input, "\"" + path + "\" is there and not of this kind; choose another name"};
  if (auto status = make_folder(file->parent_path()); !status) return status.error();
  return file;
}

}  // namespace roomgen::mcp
