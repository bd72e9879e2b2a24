#include "resources.h"

#include <cctype>
#include <nlohmann/json.hpp>
#include <string_view>

#include "roomgen/base/file.h"
#include "roomgen/scene/scene.h"

namespace roomgen::mcp {

namespace {

constexpr std::size_t most_rooms = 500;
constexpr std::string_view start = "roomgen:///", scene_end = "/scene.json", ledger_end = "/ledger.json";

Json resource(const std::string& room, std::string_view end, const std::string& title, const std::string& about) {
  return {{"uri", std::string(start) + percent_encoded(room) + std::string(end)},
          {"name", room + std::string(end)},
          {"title", title + " of " + room},
          {"description", about},
          {"mimeType", "application/json"}};
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string ledger(const Scene& scene) {
  Json json = {{"prompt", scene.prompt},
               {"heard", to_json(scene.heard)},
               {"requirements", Json::array()},
               {"unplaced", Json::array()}};
  for (const auto& verdict : scene.requirements) json["requirements"].push_back(to_json(verdict));
  for (const auto& missing : scene.unplaced)
    json["unplaced"].push_back({{"id", missing.id}, {"category", missing.category}, {"reason", missing.reason}});
  return dump_json(json);
}

Error no_resource(const std::string& uri) {
  return {Error::Kind::not_found, "no resource \"" + uri.substr(0, 200) +
                                      "\"; there are roomgen:///ROOM/scene.json and roomgen:///ROOM/ledger.json"};
}

}  // namespace

std::string percent_encoded(const std::string& path) {
  constexpr std::string_view digits = "0123456789ABCDEF", plain = "-._~/";
  std::string text;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 128 && std::isalnum(byte)) || plain.find(c) != std::string_view::npos) text += c;
    else text += {'%', digits[byte >> 4], digits[byte & 15]};
  }
  return text;
}

Result<std::string> percent_decoded(const std::string& text) {
  std::string path;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      path += text[i];
      continue;
    }
    const int high = i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
    const int low = i + 2 < text.size() ? hex_digit(text[i + 2]) : -1;
    if (high < 0 || low < 0) return Error{Error::Kind::not_found, "\"" + text + "\": % without two digits"};
    path += static_cast<char>(16 * high + low);
    i += 2;
  }
  return path;
}

Json list_resources(const RootFolder& root) {
  Json all = Json::array();
  for (const auto& room : root.rooms(most_rooms)) {
    all.push_back(resource(room, scene_end, "Scene", "The room as JSON"));
    all.push_back(resource(room, ledger_end, "Ledger", "What was asked for, and whether it is met"));
  }
  return all;
}

Result<std::string> read_resource(const RootFolder& root, const std::string& uri) {
  if (!uri.starts_with(start)) return no_resource(uri);
  const std::string rest = uri.substr(start.size());
  const bool is_scene = rest.ends_with(scene_end);
  if (!is_scene && !rest.ends_with(ledger_end)) return no_resource(uri);
  const auto room = percent_decoded(rest.substr(0, rest.size() - (is_scene ? scene_end : ledger_end).size()));
  if (!room) return room.error();
  const auto file = root.find_scene(*room);
  if (!file) return file.error();
  if (is_scene) return read_file(*file);
  const auto scene = read_scene(*file);
  if (!scene) return scene.error();
  return ledger(*scene);
}

}  // namespace roomgen::mcp
