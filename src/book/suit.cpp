#include "suit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "scene/wall_sides.h"
#include "seen_opening.h"

namespace roomgen::book {

namespace {

constexpr double of_door = 4.0, of_window = 1.5, of_outside = 3.0, of_narrow = 2.0, of_unlike = 0.5;

// In the frame of a design that is mirrored and turned, in a room whose box has that size.
Json told_back(const std::vector<SeenOpening>& seen, const Vec2& size, const Setting& setting) {
  Json openings = Json::array();
  for (const auto& one : seen) {
    // Designs tell openings along the walls counter-clockwise.
    double at = one.middle / size[one.side % 2];
    if (one.side >= 2) at = 1.0 - at;
    int side = (one.side - setting.turns + 4) % 4;
    if (setting.is_mirrored) {
      if (side % 2 == 1) side = 4 - side;
      at = 1.0 - at;
    }
    openings.push_back({{"kind", one.is_window ? "window" : "door"},
                        {"wall", compass_name(side)},
                        {"at", at},
                        {"width", one.width}});
  }
  return openings;
}

/// What stands at a wall: half its width, and its height.
struct AtWall {
  double half = 0.3, height = 1.0;
};

// The first thing of a group is its anchor.
AtWall at_wall(const Json& one) {
  const bool is_group = one.contains("things") && !one["things"].empty();
  const Json size = (is_group ? one["things"].front() : one).value("size_cm", Json());
  if (!size.is_array() || size.size() != 3 || !size[0].is_number() || !size[2].is_number())
    return {};
  return {size[0].get<double>() / 200.0, size[2].get<double>() / 100.0};
}

// What is before an opening of its wall.
double of_opening(const SeenOpening& opening, const AtWall& thing, double along) {
  if (std::abs(along - opening.middle) >= thing.half + 0.5 * opening.width) return 0.0;
  if (!opening.is_window) return of_door;
  return thing.height > opening.sill + window_overlap ? of_window : 0.0;
}

double conflicts(const Json& one, const std::vector<SeenOpening>& seen, const Room& room) {
  if (!one.contains("stands") || !one["stands"].contains("location")) return 0.0;
  const Bounds2 box = bounds(room.polygon);
  const Vec2 extent = box.size();
  const Json& location = one["stands"]["location"];
  const Vec2 at(location[0].get<double>(), location[1].get<double>());
  double fault = contains(room.polygon, box.low + at) ? 0.0 : of_outside;
  if (!one["stands"].value("wall", false)) return fault;
  const double distances[] = {at.y(), extent.x() - at.x(), extent.y() - at.y(), at.x()};
  const auto side = static_cast<int>(std::min_element(distances, distances + 4) - distances);
  const auto axis = static_cast<Eigen::Index>(side % 2);
  for (const auto& opening : seen)
    if (opening.side == side) fault += of_opening(opening, at_wall(one), at[axis]);
  return fault;
}

double unlike(const Design& design, const Json& openings) {
  double fault = 0.0;
  for (const auto& own : design.body.value("openings", Json::array())) {
    const bool is_seen_through = is_window(own);
    const bool is_met = std::any_of(openings.begin(), openings.end(), [&](const Json& other) {
      return is_window(other) == is_seen_through && other["wall"] == own.value("wall", Json());
    });
    if (!is_met) fault += of_unlike * (is_seen_through ? 1.0 : 2.0);
  }
  return fault;
}

}  // namespace

void suit(const Design& design, const Room& room, Setting& setting) {
  const auto seen = openings_seen(room);
  const Vec2 box = bounds(room.polygon).size();
  const Vec2 usual = usual_size(design, setting.values);
  double least = std::numeric_limits<double>::infinity();
  Setting best = setting;
  for (int turns = 0; turns < 4; ++turns)
    for (const bool is_mirrored : {false, true}) {
      Setting tried = setting;
      tried.turns = turns, tried.is_mirrored = is_mirrored;
      tried.openings = told_back(seen, box, tried);
      const auto answer = answer_of(design, tried);
      if (!answer) continue;
      double fault = unlike(design, tried.openings);
      for (const char* list : {"groups", "objects"})
        for (const auto& one : answer->value(list, Json::array()))
          if (one.is_object())
            fault += conflicts(one, seen, room) * (one.contains("spare") ? 0.5 : 1.0);
      const Vec2 size = turns % 2 == 0 ? setting.size : Vec2(setting.size.y(), setting.size.x());
      fault += of_narrow * (usual - size).cwiseMax(0.0).sum();
      if (fault >= least) continue;
      least = fault, best = std::move(tried);
    }
  setting = std::move(best);
}

}  // namespace roomgen::book
