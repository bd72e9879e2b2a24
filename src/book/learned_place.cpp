#include "learned_place.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "roomgen/base/text.h"

namespace roomgen::book {

namespace {

constexpr double near_wall = 1.2;  ///< metres that are kept
constexpr double near_unit = 0.6;
constexpr double in_the_middle = 0.04;
constexpr double back_at_wall = 0.10, hung_at_wall = 0.2;
constexpr double in_corner = 0.06;
constexpr double at_opening = 0.05, beside_opening = 0.12;  ///< the latter as designs are laid
constexpr double same_turn = 5.0;                           ///< degrees

double length_of(int side, const Vec2& size) {
  return side % 2 == 0 ? size.x() : size.y();
}

// From the side of the box to a point.
double distance_to(int side, const Vec2& point, const Vec2& size) {
  const double distances[] = {point.y(), size.x() - point.x(), size.y() - point.y(), point.x()};
  return distances[side];
}

bool keeps_place(double low, double high, double middle, double length) {
  const bool is_low = low < near_wall, is_high = length - high < near_wall;
  return std::abs(middle - 0.5 * length) < in_the_middle || is_low != is_high;
}

double gap_of(const Bounds2& a, const Bounds2& b) {
  return (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(0.0).norm();
}

// The wall of the room that its back is at; that of a room that is no rectangle must be there.
std::optional<int> wall_behind(const Object& object, const Room& room, const Vec2& size) {
  const auto faced = side_faced(object.yaw);
  if (!faced || object.mount == Mount::ceiling || object.traits.flat) return std::nullopt;
  const int wall = (*faced + 2) % 4;
  const Vec2 back = object.position.head<2>() - 0.5 * object.size.y() * front_direction(object.yaw);
  const double most = object.mount == Mount::wall ? hung_at_wall : back_at_wall;
  if (distance_to(wall, back, size) > most || distance_to_boundary(room.polygon, back) > most)
    return std::nullopt;
  return wall;
}

/// Tells where one unit stands.
class StandTeller {
 public:
  StandTeller(const Unit& unit, const Place2& place, const Surroundings& around)
      : unit_(unit),
        thing_(unit.anchor()),
        place_(place),
        around_(around),
        size_(bounds(around.room.polygon).size()),
        wall_(wall_behind(thing_, around.room, size_)) {}

  Json run(const std::array<std::string, 2>& numbers) const {
    if (unit_.grid.number() > 1) return at(first_copy(numbers));
    if (!wall_) return at({});
    if (const auto opening = at_an_opening(); !opening.is_null()) return opening;
    if (const auto corner = corner_of(); !corner.empty())
      return {{"corner", corner}, {"facing", compass_name((*wall_ + 2) % 4)}};
    const std::size_t axis = *wall_ % 2 == 0 ? 0 : 1;
    return {{"wall", compass_name(*wall_)}, {"along", told(place_[axis], axis == 0 ? "W" : "D")}};
  }

 private:
  Json at(const std::array<std::string, 2>& more) const {
    Json stands;
    stands["at"] = {told(place_[0], "W", more[0]), told(place_[1], "D", more[1])};
    const auto side = side_faced(thing_.yaw);
    if (side)
      stands["facing"] = compass_name(*side);
    else
      stands["facing"] = rounded(degrees(thing_.yaw), 1);
    return stands;
  }

  // The first copy is half of the others' way before their middle.
  std::array<std::string, 2> first_copy(const std::array<std::string, 2>& numbers) const {
    std::array<std::string, 2> more;
    const double steps[] = {unit_.grid.along, unit_.grid.across};
    const Vec2 axes[] = {rotated({0, 1}, thing_.yaw), rotated({1, 0}, thing_.yaw)};
    for (std::size_t i = 0; i < 2; ++i)
      for (Eigen::Index k = 0; k < 2; ++k)
        if (std::abs(axes[i][k]) > 0.5 && steps[i] > 0.0)
          more[static_cast<std::size_t>(k)] += std::string(axes[i][k] > 0.0 ? " - " : " + ") +
                                               format_number(0.5 * steps[i], 3) + "*(" +
                                               numbers[i] + " - 1)";
    return more;
  }

  double along() const { return *wall_ % 2 == 0 ? thing_.position.x() : thing_.position.y(); }

  std::string corner_of() const {
    const double half = 0.5 * thing_.size.x(), length = length_of(*wall_, size_);
    const bool is_low = along() - half < in_corner, is_high = length - along() - half < in_corner;
    if (is_low == is_high || thing_.mount != Mount::floor) return "";
    const bool is_across = *wall_ % 2 == 0;
    const std::string other = is_across ? (is_low ? "west" : "east") : (is_low ? "south" : "north");
    const std::string own(compass_name(*wall_));
    return is_across ? own + "-" + other : other + "-" + own;
  }

  Json at_an_opening() const {
    int numbers[] = {0, 0};
    for (const auto& opening : around_.openings) {
      const int number = numbers[opening.is_window]++;
      if (opening.side != *wall_) continue;
      const char* kind = opening.is_window ? "window" : "door";
      const double off = along() - opening.middle;
      if (std::abs(off) < at_opening && opening.is_window) return {{kind, number}};
      const double beside = 0.5 * opening.width + 0.5 * thing_.size.x() + beside_opening;
      if (std::abs(std::abs(off) - beside) > at_opening || thing_.mount != Mount::floor) continue;
      const bool is_left = (off > 0.0) == (opening.side == 0 || opening.side == 1);
      return {{kind, number}, {"beside", is_left ? "left" : "right"}};
    }
    return {};
  }

  const Unit& unit_;
  const Object& thing_;
  const Place2& place_;
  const Surroundings& around_;
  Vec2 size_;
  std::optional<int> wall_;
};

}  // namespace

std::optional<int> side_faced(double yaw) {
  const double turn = degrees(yaw) / 90.0, whole = std::round(turn);
  if (std::abs(turn - whole) * 90.0 > same_turn) return std::nullopt;
  return ((static_cast<int>(whole) % 4) + 4) % 4;
}

Json told(const Along& along, const char* side, const std::string& more) {
  const double offset = rounded(along.offset, 3), share = rounded(along.share, 4);
  if (share == 0.0 && more.empty()) return offset;
  const std::string sign = offset < 0.0 ? " - " : " + ",
                    metres = format_number(std::abs(offset), 3);
  if (share == 0.0) return format_number(offset, 3) + more;
  const std::string part = share == 1.0   ? std::string(side)
                           : share == 0.5 ? std::string(side) + "/2"
                                          : format_number(share, 4) + "*" + side;
  return part + (std::abs(offset) < 0.001 ? "" : sign + metres) + more;
}

Along along_of(double low, double high, double middle, double length) {
  const bool is_low = low < near_wall, is_high = length - high < near_wall;
  if (std::abs(middle - 0.5 * length) < in_the_middle) return {0.5, middle - 0.5 * length};
  if (is_low && !is_high) return {0.0, middle};
  if (is_high && !is_low) return {1.0, middle - length};
  const double before = std::max(0.0, low), after = std::max(0.0, length - high);
  const double share = rounded(before + after > 0.05 ? before / (before + after) : 0.5, 3);
  return {share, middle - share * length};
}

std::vector<Place2> places_of(const std::vector<Unit>& units, const Vec2& size) {
  std::vector<Place2> places(units.size());
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto k = static_cast<Eigen::Index>(axis);
    // Of a grid the middle of its copies' anchors.
    const auto middle = [&](const Unit& unit) {
      const Vec2 half(0.5 * unit.grid.across * (unit.grid.columns - 1),
                      0.5 * unit.grid.along * (unit.grid.rows - 1));
      return (unit.at + rotated(half, unit.anchor().yaw))[k];
    };
    std::vector<std::size_t> open, done;
    for (std::size_t i = 0; i < units.size(); ++i) {
      const Bounds2& box = units[i].box;
      places[i][axis] = along_of(box.low[k], box.high[k], middle(units[i]), size[k]);
      (keeps_place(box.low[k], box.high[k], middle(units[i]), size[k]) ? done : open).push_back(i);
    }
    std::stable_sort(open.begin(), open.end(), [&](std::size_t a, std::size_t b) {
      return units[a].box.size().prod() > units[b].box.size().prod();
    });
    // The largest stands for itself, small things follow what they are near to.
    for (const std::size_t i : open) {
      double least = near_unit;
      for (const std::size_t j : done) {
        const double gap = gap_of(units[i].box, units[j].box);
        if (gap >= least) continue;
        least = gap;
        const double share = places[j][axis].share;
        places[i][axis] = {share, middle(units[i]) - share * size[k]};
      }
      done.push_back(i);
    }
  }
  return places;
}

Json told_stands(const Unit& unit, const Place2& place, const Surroundings& around,
                 const std::array<std::string, 2>& numbers) {
  return StandTeller(unit, place, around).run(numbers);
}

}  // namespace roomgen::book
