#include "reach.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace roomgen::design {

namespace {

constexpr double body = 0.25;  ///< radius of the disc
constexpr double over_heads = 1.9;
constexpr double over_hips = 1.2;
constexpr double max_cells = 40000;

bool in_the_way(const Object& object, double bottom) {
  if (object.traits.flat || object.mount == Mount::surface || !object.on.empty()) return false;
  return bottom <= over_heads && (object.mount != Mount::wall || bottom <= over_hips);
}

// Cells where a disc may stand, then those that can be walked to.
class Floor {
 public:
  explicit Floor(const Polygon& polygon) {
    const Bounds2 box = bounds(polygon);
    pitch_ = std::max(0.1, std::sqrt(box.size().prod() / max_cells));
    low_ = box.low;
    nx_ = std::max(1, static_cast<int>(std::ceil(box.size().x() / pitch_)));
    ny_ = std::max(1, static_cast<int>(std::ceil(box.size().y() / pitch_)));
    state_.assign(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_), blocked);
    each([&](const Vec2& point, char& state) {
      if (contains(polygon, point) && distance_to_boundary(polygon, point) >= body - 0.5 * pitch_)
        state = open;
    });
  }

  void block(const Footprint& footprint) {
    each_near(footprint, body, [&](const Vec2& point, char& state) {
      if (gap(footprint, point) < body - 0.3 * pitch_) state = blocked;
    });
  }

  bool walk_from(const Footprint& start) {
    std::vector<std::size_t> todo;
    each_near(start, body, [&](const Vec2& point, char& state) {
      if (state == open && gap(start, point) <= body) {
        state = walked;
        todo.push_back(static_cast<std::size_t>(&state - state_.data()));
      }
    });
    const bool any = !todo.empty();
    while (!todo.empty()) {
      const std::size_t at = todo.back();
      todo.pop_back();
      const int x = static_cast<int>(at) % nx_, y = static_cast<int>(at) / nx_;
      visit(x - 1, y, todo);
      visit(x + 1, y, todo);
      visit(x, y - 1, todo);
      visit(x, y + 1, todo);
    }
    return any;
  }

  bool reached(const Footprint& zone) {
    bool found = false;
    each_near(zone, body, [&](const Vec2& point, char& state) {
      found = found || (state == walked && gap(zone, point) <= body);
    });
    return found;
  }

 private:
  enum : char { blocked, open, walked };

  Vec2 point(int x, int y) const { return low_ + pitch_ * Vec2(x + 0.5, y + 0.5); }

  char& at(int x, int y) {
    return state_[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) +
                  static_cast<std::size_t>(x)];
  }

  void visit(int x, int y, std::vector<std::size_t>& todo) {
    if (x < 0 || y < 0 || x >= nx_ || y >= ny_ || at(x, y) != open) return;
    at(x, y) = walked;
    todo.push_back(static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) +
                   static_cast<std::size_t>(x));
  }

  template <typename F>
  void each(const F& visit_cell) {
    for (int y = 0; y < ny_; ++y)
      for (int x = 0; x < nx_; ++x) visit_cell(point(x, y), at(x, y));
  }

  template <typename F>
  void each_near(const Footprint& footprint, double margin, const F& visit_cell) {
    const auto cell = [&](double value, double low, int count) {
      return std::clamp(static_cast<int>(std::floor((value - low) / pitch_)), 0, count - 1);
    };
    const Bounds2& box = footprint.bounds();
    for (int y = cell(box.low.y() - margin, low_.y(), ny_);
         y <= cell(box.high.y() + margin, low_.y(), ny_); ++y)
      for (int x = cell(box.low.x() - margin, low_.x(), nx_);
           x <= cell(box.high.x() + margin, low_.x(), nx_); ++x)
        visit_cell(point(x, y), at(x, y));
  }

  Vec2 low_ = Vec2::Zero();
  double pitch_ = 0.1;
  int nx_ = 1, ny_ = 1;
  std::vector<char> state_;
};

bool any_reached(Floor& floor, const Footprint& footprint, const std::vector<UseZone>& zones) {
  return zones.empty() || std::any_of(zones.begin(), zones.end(), [&](const UseZone& zone) {
           return floor.reached(zone_footprint(footprint, zone));
         });
}

}  // namespace

bool all_reachable(const Sketch& sketch, const Object& self, const Pose& pose, double bottom) {
  Floor floor(sketch.room().polygon);
  const Footprint own = footprint_at(self, pose);
  if (in_the_way(self, bottom)) floor.block(own);
  for (const auto& one : sketch.standing())
    if (in_the_way(*one.object, roomgen::bottom(*one.object))) floor.block(one.footprint);

  std::vector<Footprint> doors;
  for (const auto& opening : sketch.room().openings)
    if (opening.is_entrance()) doors.push_back(door_clearance(sketch.room(), opening));
  if (doors.empty()) return true;
  floor.walk_from(doors.front());
  if (!std::all_of(doors.begin(), doors.end(),
                   [&](const Footprint& d) { return floor.reached(d); }))
    return false;
  return any_reached(floor, own, sketch.categories().get(self.category).zones) &&
         std::all_of(sketch.standing().begin(), sketch.standing().end(), [&](const Standing& one) {
           return any_reached(floor, one.footprint, one.zones);
         });
}

}  // namespace roomgen::design
