#include "floor_plan.h"

#include <algorithm>
#include <cmath>

#include "scene/wall_sides.h"

namespace roomgen::plan {

namespace {

double to_grid(double metres) {
  return std::round(metres * 10.0) / 10.0;
}

// Width and depth of a given area in the proportions of the kind.
Vec2 of_area(double area, const brief::RoomKind& kind, Random& random) {
  const double usual =
      0.5 * (kind.width.low + kind.width.high) / (0.5 * (kind.depth.low + kind.depth.high));
  const double ratio = std::clamp(usual * random.uniform(0.9, 1.15), 1.0, 2.5);
  const double depth = std::sqrt(area / ratio);
  return {area / depth, depth};
}

// In the proportions that the prompt asks for.
Vec2 of_proportion(double area, const brief::Brief& brief, Random& random) {
  const double ratio = random.uniform(brief.shape.proportion->low, brief.shape.proportion->high);
  return brief::box_of(area, ratio, true);
}

// Long and wide enough for a block, whichever way it lies.
Vec2 around_block(const Vec2& size, const Vec2& block) {
  const Vec2 least = size.x() < size.y() ? Vec2(block.minCoeff(), block.maxCoeff()) : Vec2(block.maxCoeff(), block.minCoeff());
  return size.cwiseMax(least.cwiseMin(std::sqrt(max_chosen_area)));
}

}  // namespace

double size_factor(const brief::RoomKinds& kinds, const std::vector<std::string>& styles) {
  double factor = 1.0;
  for (const auto& word : styles)
    if (const brief::Style* style = kinds.style(word)) factor *= style->size;
  return std::clamp(factor, 0.6, 1.6);
}

Vec2 choose_size(const brief::RoomKind& kind, const brief::Brief& brief, double scale,
                 double furniture, const Vec2& block, Random random) {
  if (brief.size) return *brief.size;
  if (brief.area) {
    const Vec2 size = brief.shape.proportion ? of_proportion(*brief.area, brief, random)
                                             : of_area(*brief.area, kind, random);
    return {std::round(size.x() * 100) / 100, std::round(size.y() * 100) / 100};
  }
  const double depth = random.uniform(kind.depth.low, kind.depth.high);
  Vec2 size(random.uniform(kind.width.low, kind.width.high), depth);
  size *= scale;
  const double needed = furniture / std::max(0.1, kind.share.high);
  if (size.prod() < needed) size *= std::sqrt(needed / size.prod());
  if (size.prod() > max_chosen_area) size *= std::sqrt(max_chosen_area / size.prod());
  if (brief.shape.proportion) size = of_proportion(size.prod(), brief, random);
  size = size.cwiseMax(brief.shape.proportion ? 0.7 * kind.smallest : kind.smallest).cwiseMin(20.0);
  size = around_block(size, block);
  size = Vec2(to_grid(size.x()), to_grid(size.y()));
  while (size.prod() > max_chosen_area + 1e-9) size.x() = to_grid(size.x() - 0.1);
  if (random.chance(0.3)) std::swap(size.x(), size.y());
  return size;
}

brief::Outline choose_outline(const brief::Brief& brief, const Vec2& chosen, bool is_box,
                       std::vector<std::string>& notes, Random random) {
  const auto& shapes = brief::built_in_floor_shapes();
  if (brief.shape.is_rectangle() || !shapes) return brief::rectangle_of(chosen);
  brief::OutlineSize size{chosen, std::nullopt};
  const auto known = shapes->outlines.find(brief.shape.outline);
  const double nooks = known == shapes->outlines.end() ? 1.0 : known->second.area;
  if (!is_box) size.area = brief.area ? *brief.area : nooks * chosen.prod();
  brief::Outline outline = brief::make_outline(brief.shape, *shapes, size, random);
  for (const auto& name : outline.missing)
    notes.push_back("no wall of a room of this size is long enough for the " + name);
  return outline;
}

Room make_room(const brief::RoomKind& kind, const brief::Outline& outline,
               const RoomOpenings& openings, Random random, std::vector<std::string>& notes) {
  Room room;
  room.type = kind.type;
  room.height = kind.height;
  room.polygon = outline.polygon;
  plan_openings(room, kind, outline.glazed, openings, random, notes);
  if (!kind.floors.empty()) room.materials.floor = random.pick(kind.floors);
  if (!kind.walls.empty()) room.materials.walls = random.pick(kind.walls);
  room.materials.ceiling = "white ceiling";
  return room;
}

void put_on(Room& room, const StyleMeaning& style, Random random) {
  const auto choose = [&](std::string& has, const std::vector<std::string>& words) {
    if (!words.empty()) has = random.pick(words);
  };
  const bool is_tiled = room.materials.floor.find("tile") != std::string::npos;
  choose(room.materials.walls, style.walls);
  if (!style.accents.empty())
    choose(cover_named(room.materials, accent_name).finish, style.accents);
  if (!is_tiled) choose(room.materials.floor, style.floors);
}

void put_on(Room& room, const RoomMaterials& said) {
  const auto replace = [](std::string& has, const std::string& wanted) {
    if (!wanted.empty()) has = wanted;
  };
  // What is said of the walls is said of all of them.
  if (!said.walls.empty()) room.materials.covers.clear();
  replace(room.materials.floor, said.floor);
  replace(room.materials.walls, said.walls);
  replace(room.materials.ceiling, said.ceiling);
  for (const auto& cover : said.covers) cover_named(room.materials, cover.wall) = cover;
}

namespace {

constexpr std::size_t south_side = 0, east_side = 1, north_side = 2, west_side = 3;

// Of the two longer walls (or the two shorter ones) first that which no door is in.
std::string wall_of_length(const Room& room, bool is_long, bool is_other) {
  const Vec2 size = bounds(room.polygon).size();
  const bool along_x = (size.x() >= size.y()) == is_long;
  std::size_t one = wall_on_side(room.polygon, along_x ? north_side : east_side);
  std::size_t other = wall_on_side(room.polygon, along_x ? south_side : west_side);
  const auto has_door = [&](std::size_t wall) {
    return std::any_of(room.openings.begin(), room.openings.end(),
                       [&](const Opening& opening) { return opening.wall == wall && opening.is_entrance(); });
  };
  if (has_door(one) && !has_door(other)) std::swap(one, other);
  return "wall-" + std::to_string(is_other ? other : one);
}

}  // namespace

std::string part_of(const Room& room, const std::string& said) {
  const bool is_other = said.starts_with("other-");
  if (said.ends_with("long-wall") || said.ends_with("short-wall")) return wall_of_length(room, said.ends_with("long-wall"), is_other);
  if (said == "one-end" || said == "other-end") {
    const Vec2 size = bounds(room.polygon).size();
    if (size.x() >= size.y()) return is_other ? "east-third" : "west-third";
    return is_other ? "north-third" : "south-third";
  }
  for (std::size_t side = 0; side < 4; ++side)
    if (said == "wall-" + std::to_string(side))
      return "wall-" + std::to_string(wall_on_side(room.polygon, side));
  return said;
}

}  // namespace roomgen::plan
