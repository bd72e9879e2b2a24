#include "root_folder.h"

#include <algorithm>

#include "roomgen/base/text.h"

namespace roomgen::mcp {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_path = 4096;
constexpr std::size_t most_entries = 100'000;  // that are looked at for rooms
constexpr int deepest_room = 6;

Error refused(const std::string& path, const std::string& why) {
  return {Error::Kind::invalid_input, "\"" + shortened(path, 200) + "\" " + why};
}

// What resolving left of links: those that lead nowhere.
bool has_link(const fs::path& root, const fs::path& resolved) {
  std::error_code code;
  fs::path so_far = root;
  for (const auto& part : resolved.lexically_relative(root)) {
    so_far /= part;
    if (fs::is_symlink(fs::symlink_status(so_far, code))) return true;
  }
  return false;
}

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with("."); }

}  // namespace

Result<RootFolder> RootFolder::open(const fs::path& folder) {
  std::error_code code;
  const fs::path path = fs::canonical(folder, code);
  if (code || !fs::is_directory(path, code))
    return Error{Error::Kind::not_found, folder.string() + ": is no folder; make it first, or name another root"};
  return RootFolder(path);
}

bool RootFolder::holds(const fs::path& resolved) const {
  const auto [root_end, end] = std::mismatch(path_.begin(), path_.end(), resolved.begin(), resolved.end());
  return root_end == path_.end();
}

Result<fs::path> RootFolder::find(const std::string& path) const {
  if (path.empty() || path.size() > longest_path || path.find('\0') != std::string::npos)
    return refused(path, "is no path");
  std::error_code code;
  const fs::path resolved = fs::weakly_canonical(path_ / path, code);
  if (code) return refused(path, "cannot be followed: " + code.message());
  if (!holds(resolved))
    return refused(path, "leads out of the root folder " + path_.string() +
                             "; name a path below it, such as \"bedroom\"");
  if (has_link(path_, resolved)) return refused(path, "is a link that leads nowhere");
  return resolved;
}

Error RootFolder::no_room(const std::string& room) const {
  const std::string known = join(rooms(20), ", ");
  return {Error::Kind::not_found, "\"" + shortened(room, 200) + "\" holds no room; " +
                                      (known.empty() ? "make one with generate" : "rooms are: " + known)};
}

Result<fs::path> RootFolder::find_scene(const std::string& room) const {
  auto place = find(room);
  if (!place) return place.error();
  std::error_code code;
  if (!fs::exists(*place, code)) return no_room(room);
  const fs::path file = fs::is_directory(*place, code) ? *place / "scene.json" : *place;
  if (file.extension() != ".json") return refused(room, "is no scene; name a room's folder, or its scene.json");
  if (!fs::exists(file, code)) return no_room(room);
  fs::path journal = file;
  journal.replace_extension(".journal");
  for (const auto& each : {file, journal, file.parent_path() / "scene.glb", file.parent_path() / "trace.jsonl"}) {
    if (!fs::is_symlink(fs::symlink_status(each, code))) continue;
    if (auto inside = find(each.string()); !inside) return inside.error();
  }
  return file;
}

std::string RootFolder::name_of(const fs::path& path) const { return path.lexically_relative(path_).generic_string(); }

std::vector<std::string> RootFolder::rooms(std::size_t most) const {
  std::vector<std::string> names;
  std::error_code code;
  std::size_t seen = 0;
  if (fs::is_regular_file(path_ / "scene.json", code)) names.push_back(".");
  fs::recursive_directory_iterator at(path_, fs::directory_options::skip_permission_denied, code);
  for (; !code && at != fs::recursive_directory_iterator() && seen < most_entries; at.increment(code), ++seen) {
    std::error_code ignored;
    if (!at->is_directory(ignored) || at->is_symlink(ignored)) continue;
    if (is_hidden(at->path()) || at.depth() >= deepest_room) {
      at.disable_recursion_pending();
      continue;
    }
    if (fs::is_regular_file(at->path() / "scene.json", ignored)) names.push_back(name_of(at->path()));
  }
  std::sort(names.begin(), names.end());
  if (names.size() > most) names.resize(most);
  return names;
}

}  // namespace roomgen::mcp
