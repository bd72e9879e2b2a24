#include "learned_shell.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "roomgen/base/text.h"

namespace roomgen::book {

namespace {

constexpr double most_of_wall =
    0.5;                             ///< that an opening takes without giving way in a smaller room
constexpr double beside_wide = 0.8;  ///< metres of wall beside such an opening

bool stands_alone(const std::string& text, std::size_t at, std::size_t length) {
  const auto is_letter = [&](std::size_t i) {
    return std::isalnum(static_cast<unsigned char>(text[i])) != 0;
  };
  return (at == 0 || !is_letter(at - 1)) && (at + length >= text.size() || !is_letter(at + length));
}

// All texts within.
void word_texts(Json& json, const std::function<std::string(std::string)>& worded) {
  if (json.is_string())
    json = worded(json.get<std::string>());
  else if (json.is_structured())
    for (auto& value : json) word_texts(value, worded);
}

// The walls of a plan have numbers, those of a design the names of their sides.
void name_walls(Json& covers, const Room& room) {
  for (auto& cover : covers) {
    if (!cover.is_object() || !cover.contains("wall") || !cover["wall"].is_string()) continue;
    const std::string name = cover["wall"].get<std::string>();
    if (!name.starts_with("wall-")) continue;
    const std::size_t number = std::strtoul(name.c_str() + 5, nullptr, 10);
    if (number >= room.polygon.size()) continue;
    if (const auto side = side_faced(yaw_facing(-room.polygon.inward(number))))
      cover["wall"] = compass_name(*side);
  }
}

// "table lamp-0" is a table lamp.
Json told_light(Json light) {
  if (!light.contains("lamps") || !light["lamps"].is_array()) return light;
  Json lamps = Json::array();
  for (const auto& lamp : light["lamps"]) {
    std::string name = lamp.get<std::string>();
    const std::size_t number = name.find_last_not_of("0123456789");
    if (number != std::string::npos && number + 1 < name.size() && name[number] == '-')
      name.erase(number);
    if (std::find(lamps.begin(), lamps.end(), Json(name)) == lamps.end()) lamps.push_back(name);
  }
  light["lamps"] = std::move(lamps);
  return light;
}

// Along a wall counter-clockwise: on the north and west walls from their other end.
Json told_at(const Along& along, int side, double length) {
  const char* name = side % 2 == 0 ? "W" : "D";
  const bool is_back = side >= 2;
  if (along.share != 0.0 && along.share != 1.0) {
    const double part = along.at(length) / length;
    return rounded(is_back ? 1.0 - part : part, 4);
  }
  const bool is_from_end = (along.share == 1.0) != is_back;
  const std::string part = format_number(std::abs(along.offset), 3) + "/" + name;
  return is_from_end ? "1 - " + part : part;
}

}  // namespace

std::function<std::string(std::string)> with_roles(const Room& room) {
  std::vector<std::pair<std::string, std::string>> roles;
  for (const auto& [role, word] : room.palette)
    if (word.size() > 2) roles.emplace_back(lower(word), role);
  std::stable_sort(roles.begin(), roles.end(),
                   [](const auto& a, const auto& b) { return a.first.size() > b.first.size(); });
  return [roles](std::string text) {
    for (const auto& [word, role] : roles)
      for (std::size_t at = 0; (at = lower(text).find(word, at)) != std::string::npos;) {
        const std::string name = "{" + role + "}";
        const bool is_word = stands_alone(text, at, word.size());
        if (is_word) text.replace(at, word.size(), name);
        at += is_word ? name.size() : word.size();
      }
    return text;
  };
}

Json told_room(const Room& room, const std::function<std::string(std::string)>& worded) {
  const Json all = to_json(room);
  Json told = {{"type", room.type}, {"height_m", rounded(room.height, 3)}};
  for (const char* part : {"materials", "style"})
    if (all.contains(part)) told[part] = all[part];
  if (all.contains("light")) told["light"] = told_light(all["light"]);
  if (told.contains("materials")) {
    word_texts(told["materials"], worded);
    if (told["materials"].contains("walls") && told["materials"]["walls"].is_array())
      name_walls(told["materials"]["walls"], room);
  }
  if (!room.palette.empty()) told["palettes"] = Json::array({Json(room.palette)});
  return told;
}

Json told_openings(const Room& room) {
  Json told = Json::array();
  const auto seen = openings_seen(room);
  const Vec2 size = bounds(room.polygon).size();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Opening& opening = room.openings[i];
    const double length = seen[i].side % 2 == 0 ? size.x() : size.y(), half = 0.5 * opening.width();
    const double middle = seen[i].middle;
    Json one = {{"kind", opening.kind.empty() ? std::string(name(opening.type)) : opening.kind},
                {"wall", compass_name(seen[i].side)},
                {"at", told_at(along_of(middle - half, middle + half, middle, length), seen[i].side,
                               length)},
                {"width", rounded(opening.width(), 3)}};
    if (opening.width() > most_of_wall * length)
      one["width"] = "min(" + format_number(opening.width(), 3) + ", " +
                     (seen[i].side % 2 == 0 ? "W" : "D") + " - " +
                     format_number(std::min(beside_wide, length - opening.width()), 3) + ")";
    if (!opening.is_entrance()) one["sill"] = rounded(opening.sill, 3);
    one["head"] = rounded(opening.head, 3);
    if (!opening.purpose.empty()) one["for"] = opening.purpose;
    told.push_back(std::move(one));
  }
  return told;
}

}  // namespace roomgen::book
