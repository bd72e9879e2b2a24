#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "roomgen/base/text.h"
#include "roomgen/edit/session.h"
#include "scene/room_look_json.h"

namespace roomgen {

namespace {

constexpr double told_move = 0.005, told_turn = 0.009;  // metres, radians (half a degree)
constexpr double mostly = 0.7;  // share of a move by which it comes nearer to what it is towards

std::string metres(double length) { return format_number(length, length < 0.1 ? 2 : 1) + " m"; }

// The thing to which the way led most directly, among those that are nearest at its end.
std::string towards(const Object& before, const Object& after, const Scene& scene) {
  const double way = (after.position - before.position).head<2>().norm();
  const Object* best = nullptr;
  double nearest = 0.0;
  for (const auto& other : scene.objects) {
    if (other.id == after.id || other.room != after.room || other.traits.flat || other.on == after.id) continue;
    const double was = (other.position - before.position).head<2>().norm();
    const double is = (other.position - after.position).head<2>().norm();
    if (was - is < mostly * way || (best && is >= nearest)) continue;
    best = &other;
    nearest = is;
  }
  return best ? " towards " + best->id : "";
}

std::string turned_words(double turn) {
  const std::string by = format_number(std::abs(degrees(turn)), 0) + " degrees";
  return "turned by " + by + (turn > 0 ? " to the left" : " to the right");
}

std::string finish_words_of(const AssetRef& asset) {
  std::vector<std::string> texts;
  for (const auto& [stuff, text] : asset.finish) texts.push_back(stuff + " " + text);
  return texts.empty() ? "as it came" : join(texts, ", ");
}

void add_asset_words(const Object& before, const Object& after, std::vector<std::string>& words) {
  if (before.asset == after.asset) return;
  AssetRef plain_before = before.asset, plain_after = after.asset;
  plain_before.finish.clear();
  plain_after.finish.clear();
  if (plain_before != plain_after) words.push_back("is another model: " + after.description);
  else words.push_back("looks otherwise: " + finish_words_of(after.asset));
}

std::vector<std::string> changes_of(const Object& before, const Object& after, const Scene& scene) {
  std::vector<std::string> words;
  const Vec3 way = after.position - before.position;
  if (way.head<2>().norm() > told_move)
    words.push_back("moved " + metres(way.head<2>().norm()) + towards(before, after, scene));
  else if (std::abs(way.z()) > told_move)
    words.push_back((way.z() > 0 ? "is higher by " : "is lower by ") + metres(std::abs(way.z())));
  if (const double turn = wrap_angle(after.yaw - before.yaw); std::abs(turn) > told_turn)
    words.push_back(turned_words(turn));
  if (before.on != after.on && !after.on.empty()) words.push_back("now stands on " + after.on);
  if (size_text(before.size) != size_text(after.size))
    words.push_back("is now " + size_text(after.size) + " m, not " + size_text(before.size));
  add_asset_words(before, after, words);
  if (before.locked != after.locked) words.push_back(after.locked ? "is locked" : "is no longer locked");
  if (words.empty() && before.description != after.description) words.push_back("is described otherwise");
  return words;
}

std::string place_words(const Object& object) {
  if (!object.on.empty()) return " on " + object.on;
  return " at " + format_number(object.position.x(), 2) + ", " + format_number(object.position.y(), 2);
}

void add_object_words(const Scene& before, const Scene& after, std::vector<std::string>& lines) {
  for (const auto& object : before.objects)
    if (!find_object(after, object.id)) lines.push_back(object.id + " is gone");
  for (const auto& object : after.objects) {
    const Object* old = find_object(before, object.id);
    if (!old) lines.push_back(object.id + " is new" + place_words(object));
    else if (const auto words = changes_of(*old, object, after); !words.empty())
      lines.push_back(object.id + " " + join(words, ", "));
  }
}

std::string opening_words(const Opening& opening) {
  return opening.id + " in wall-" + std::to_string(opening.wall) + ", " + format_number(opening.width(), 2) + " m wide";
}

bool is_same(const Opening& a, const Opening& b) {
  return a.wall == b.wall && a.from == b.from && a.to == b.to && a.sill == b.sill && a.head == b.head;
}

// A wall beside one that moved is longer; what is in it has not moved.
bool is_where_it_was(const Room& before, const Opening& was, const Room& after, const Opening& is) {
  return (segment(before, was).middle() - segment(after, is).middle()).norm() < told_move && was.sill == is.sill &&
         was.head == is.head && std::abs(was.width() - is.width()) < told_move;
}

void add_shape_words(const Room& before, const Room& after, const std::string& room, std::vector<std::string>& lines) {
  for (const auto& opening : before.openings)
    if (!find_opening(after, opening.id)) lines.push_back(room + opening.id + " is walled up");
  for (const auto& opening : after.openings) {
    const Opening* old = find_opening(before, opening.id);
    if (!old) lines.push_back(room + "new: " + opening_words(opening));
    else if (!is_same(*old, opening) && !is_where_it_was(before, *old, after, opening))
      lines.push_back(room + "changed: " + opening_words(opening));
  }
  if (before.height != after.height)
    lines.push_back(room + "the ceiling is at " + metres(after.height) + ", not " + metres(before.height));
  if (before.polygon.points == after.polygon.points) return;
  const Vec2 was = bounds(before.polygon).size(), is = bounds(after.polygon).size();
  lines.push_back(room + "the room is " + format_number(is.x(), 2) + " x " + metres(is.y()) + ", not " +
                  format_number(was.x(), 2) + " x " + metres(was.y()));
}

void add_room_words(const Scene& before, const Scene& after, std::vector<std::string>& lines) {
  const auto old_rooms = rooms_of(before), new_rooms = rooms_of(after);
  if (old_rooms.size() != new_rooms.size()) return lines.push_back("there are other rooms");
  for (std::size_t i = 0; i < new_rooms.size(); ++i) {
    const RoomMaterials &old = old_rooms[i].materials, &now = new_rooms[i].materials;
    const std::string room = new_rooms[i].id.empty() ? "" : new_rooms[i].id + ": ";
    using Change = std::tuple<std::string, std::string, std::string>;
    std::vector<Change> parts = {{"floor", old.floor, now.floor},
                                 {"walls", old.walls, now.walls},
                                 {"ceiling", old.ceiling, now.ceiling},
                                 {"accent wall", finish_named(old, accent_name), finish_named(now, accent_name)}};
    for (std::size_t k = 0; k < new_rooms[i].polygon.size(); ++k) {
      const std::string wall = "wall-" + std::to_string(k);
      parts.emplace_back(wall, finish_named(old, wall), finish_named(now, wall));
    }
    for (const auto& [part, was, is] : parts)
      if (was != is)
        lines.push_back(room + part + ": " + (is.empty() ? "none" : is) + ", not " + (was.empty() ? "none" : was));
    if (old_rooms[i].light != new_rooms[i].light)
      lines.push_back(room + "light: " + json_line(light_json(new_rooms[i].light)));
    add_shape_words(old_rooms[i], new_rooms[i], room, lines);
  }
}

std::string verdict_words(const RequirementVerdict& verdict) {
  return "\"" + verdict.requirement.clause + "\" " +
         (verdict.compliance == Compliance::withdrawn ? "is withdrawn"
                                                      : "is " + std::string(name(verdict.compliance)));
}

void add_ledger_words(const Scene& before, const Scene& after, std::vector<std::string>& lines) {
  std::map<std::string, Compliance> was;
  for (const auto& verdict : before.requirements) was[verdict.requirement.id] = verdict.compliance;
  for (const auto& verdict : after.requirements) {
    const auto old = was.find(verdict.requirement.id);
    if (old == was.end()) lines.push_back("asked for: " + verdict_words(verdict));
    else if (old->second != verdict.compliance) lines.push_back("now " + verdict_words(verdict));
  }
}

}  // namespace

std::vector<std::string> differences(const Scene& before, const Scene& after) {
  std::vector<std::string> lines;
  add_object_words(before, after, lines);
  add_room_words(before, after, lines);
  add_ledger_words(before, after, lines);
  return lines;
}

}  // namespace roomgen
