#include "spots.h"

#include <algorithm>
#include <cmath>

namespace roomgen::create {

namespace {

constexpr double joint = 0.003;    // how deep parts sink into each other, metres
constexpr double gap_share = 0.1;  // of a row is left free between copies
constexpr int steps_a_turn = 12;
constexpr double golden_angle = 2.399963;  // neighbours on a stem never stand above each other

double share(int i, int count) {
  return count < 2 ? 0.5 : static_cast<double>(i) / (count - 1);
}

// On an ellipse, the odd ones with one at the back.
Vec2 on_ring(int i, int count, const Vec2& radii) {
  const double angle = (count % 2 ? pi / 2 : pi / 2 + pi / count) + 2 * pi * i / count;
  return {radii.x() * std::cos(angle), radii.y() * std::sin(angle)};
}

// One in the middle, two left and right, four at the corners, others around.
Vec2 standing_point(int i, int count, const Vec2& room) {
  if (count == 1) return Vec2::Zero();
  if (count == 2) return {(i ? 1 : -1) * room.x(), 0};
  if (count == 4) return {(i % 2 ? 1 : -1) * room.x(), (i / 2 ? 1 : -1) * room.y()};
  return on_ring(i, count, room);
}

Vec2 room_for(const Vec3& size, const Frame& frame, double inset) {
  const Vec2 free = 0.5 * (frame.size.head<2>() - size.head<2>()) - Vec2::Constant(inset);
  return free.cwiseMax(0.0);
}

std::vector<Spot> feet(int count, Vec3 size, const Frame& frame) {
  const double most = std::min(frame.size.x(), frame.size.y()) / (count > 1 ? 2.2 : 1.0);
  size.head<2>() = size.head<2>().cwiseMin(most);
  size.z() = frame.low + joint;
  std::vector<Spot> result;
  const Vec2 room = room_for(size, frame, 0.02 * frame.size.head<2>().minCoeff());
  for (int i = 0; i < count; ++i) {
    const Vec2 at = standing_point(i, count, room);
    result.push_back({{at.x(), at.y(), 0}, Vec3::Zero(), size});
  }
  return result;
}

// The n-th of a series against the first.
void vary(Spot& spot, int i, const Series& series) {
  spot.size.head<2>() *= std::pow(series.scale, i);
  spot.turn.z() += i * series.turn;
}

std::vector<Spot> slabs(int count, Vec3 size, Series series) {
  if (series.scale == 1.0) series.scale = 0.84;
  std::vector<Spot> result;
  for (int i = 0; i < count; ++i) {
    result.push_back({{0, 0, i * size.z()}, Vec3::Zero(), size + Vec3(0, 0, joint)});
    vary(result.back(), i, series);
  }
  return result;
}

std::vector<Spot> columns(int count, Vec3 size, const Frame& frame) {
  size.z() = frame.high - frame.low;
  std::vector<Spot> result;
  const double reach = count < 2 ? 0.0 : 0.4 * frame.size.x();
  if (count > 1) size.head<2>() *= std::min(1.0, reach / (count * size.x()));
  for (int i = 0; i < count; ++i)
    result.push_back({{reach * (2 * share(i, count) - 1), 0, frame.low}, Vec3::Zero(), size});
  return result;
}

std::vector<Spot> uprights(int count, Vec3 size, const Frame& frame) {
  size.z() = frame.high - frame.low;
  std::vector<Spot> result;
  const Vec2 room = room_for(size, frame, 0.0);
  for (int i = 0; i < count; ++i) {
    const Vec2 at = standing_point(i, count, room);
    result.push_back({{at.x(), at.y(), frame.low}, Vec3::Zero(), size});
  }
  return result;
}

// A single board lies on the feet, several hang between low and high.
std::vector<Spot> boards(int count, const Vec3& size, const Frame& frame, const Series& series) {
  std::vector<Spot> result;
  const double rise = frame.high - frame.low;
  const bool alone = count == 1 && !frame.framed;
  const double first = alone ? frame.low : frame.low + (count > 1 ? 0.04 : 0.6) * rise;
  for (int i = 0; i < count; ++i) {
    const double z = first + (count > 1 ? share(i, count) * (frame.high - size.z() - first) : 0.0);
    result.push_back({{0, 0, z}, Vec3::Zero(), size});
    vary(result.back(), i, series);
  }
  return result;
}

std::vector<Spot> bars(int count, Vec3 size, const Frame& frame) {
  std::vector<Spot> result;
  const double rise = frame.high - frame.low;
  size.z() = std::min(size.z(), 0.9 * rise / count);
  for (int i = 0; i < count; ++i) {
    const double middle = frame.low + rise * (count == 1 ? 0.85 : 0.2 + 0.7 * share(i, count));
    result.push_back({{0, 0, middle - 0.5 * size.z()}, Vec3::Zero(), size});
  }
  return result;
}

std::vector<Spot> pile(int count, Vec3 size, const Frame& frame, const Series& series) {
  std::vector<Spot> result;
  const double each = (frame.high - frame.low) / count;
  const double flat = size.z();
  size.z() = each;
  // What is as wide as high stays so: balls.
  if (std::abs(size.x() - flat) < 1e-9 && std::abs(size.y() - flat) < 1e-9)
    size.head<2>() = Vec2::Constant(std::min({each, frame.size.x(), frame.size.y()}));
  for (int i = 0; i < count; ++i) {
    const double sink = i ? 0.02 * each : 0.0;
    result.push_back({{0, 0, frame.low + i * each - sink}, Vec3::Zero(), size + Vec3(0, 0, sink)});
    vary(result.back(), i, series);
  }
  return result;
}

// From the axis outward along `angle`, the inner end in the middle.
Spot outward(double angle, double z, const Vec3& size) {
  const Vec2 middle = 0.5 * size.x() * Vec2(std::cos(angle), std::sin(angle));
  return {{middle.x(), middle.y(), z}, {0, 0, angle}, size};
}

std::vector<Spot> winding(int count, Vec3 size, const Frame& frame) {
  std::vector<Spot> result;
  const double rise = (frame.high - frame.low - size.z()) / std::max(1, count - 1);
  size.x() = std::max(size.x(), 0.5 * frame.size.x());
  for (int i = 0; i < count; ++i)
    result.push_back(outward(2 * pi * i / steps_a_turn - pi / 2, frame.low + i * rise, size));
  return result;
}

std::vector<Spot> rays(int count, const Vec3& size, const Frame& frame, bool spread) {
  std::vector<Spot> result;
  const double rise = frame.high - frame.low - size.z();
  for (int i = 0; i < count; ++i) {
    const double height = spread ? 0.35 + 0.62 * share(i, count) : 0.8;
    const double angle = spread ? i * golden_angle : 2 * pi * (i + 0.5) / count - pi / 2;
    result.push_back(outward(angle, frame.low + height * rise, size));
  }
  return result;
}

// Turned about the axis from front to back. A hub between uprights is in the middle of the depth.
std::vector<Spot> blades(int count, const Vec3& size, const Frame& frame) {
  std::vector<Spot> result;
  const double reach = 0.5 * (frame.high - frame.low);
  const double length = std::min(size.x(), 0.95 * reach);
  const double y = frame.framed ? 0.0 : frame.core.low.y() - 0.5 * size.y() + joint;
  const double z = frame.framed ? frame.low + reach : frame.high - length;
  for (int i = 0; i < count; ++i) {
    const double angle = pi / 2 - 2 * pi * i / count;
    const Vec3 middle(0.5 * length * std::cos(angle), y, z + 0.5 * length * std::sin(angle));
    result.push_back({middle, {0, -angle, 0}, {length, size.y(), size.z()}, true});
  }
  return result;
}

std::vector<Spot> circle(int count, Vec3 size, const Frame& frame) {
  const Vec2 outer = 0.5 * frame.size.head<2>();
  // Neighbours touch.
  const double across = count < 3 ? size.x() : 2.1 * outer.minCoeff() * std::sin(pi / count) /
                                                   (1 + std::sin(pi / count));
  size *= across / size.x();
  std::vector<Spot> result;
  for (int i = 0; i < count; ++i) {
    const Vec2 at = on_ring(i, count, outer - Vec2::Constant(0.5 * across));
    result.push_back({{at.x(), at.y(), frame.low}, Vec3::Zero(), size});
  }
  return result;
}

// What lies flat shows its upper side: a board with pegs.
bool lies_flat(const Vec3& core) {
  return core.z() < 0.25 * core.head<2>().minCoeff();
}

// The part's front up.
Spot laid(const Spot& upright, const Frame& frame) {
  const double y = upright.at.z() + 0.5 * upright.size.z() - frame.core.center().z();
  Spot spot = upright;
  spot.turn.x() = -pi / 2;
  spot.about_middle = true;
  spot.at = {upright.at.x(), frame.core.center().y() + y,
             frame.core.high.z() + 0.5 * upright.size.y() - joint};
  return spot;
}

// In rows and columns on the front, as square as the face allows.
std::vector<Spot> on_front(int count, Vec3 size, const Frame& frame, const Series& series) {
  const bool flat = lies_flat(frame.core.size());
  Vec3 face = frame.core.size();
  if (flat) face.z() = face.y();
  const double want = std::sqrt(count * face.x() / face.z() * size.z() / size.x());
  const int in_row = std::clamp(static_cast<int>(std::lround(want)), 1, count);
  const int rows = (count + in_row - 1) / in_row;
  const Vec2 cell(face.x() / in_row, face.z() / rows);
  const double fit = std::min({1.0, (1 - gap_share) * cell.x() / size.x(),
                               (1 - gap_share) * cell.y() / size.z()});
  size.x() *= fit, size.z() *= fit;
  std::vector<Spot> result;
  for (int i = 0; i < count; ++i) {
    const int row = i / in_row, here = std::min(in_row, count - row * in_row);
    const double x = frame.core.center().x() + cell.x() * (i % in_row - 0.5 * (here - 1));
    const double z = frame.core.center().z() + 0.5 * face.z() - (row + 0.5) * cell.y();
    Spot spot{{x, frame.core.low.y() - 0.5 * size.y() + joint, z - 0.5 * size.z()}, Vec3::Zero(), size};
    const double smaller = std::pow(series.scale, i);
    spot.at.z() += 0.5 * (1 - smaller) * size.z();
    spot.size.x() *= smaller, spot.size.z() *= smaller;
    result.push_back(flat ? laid(spot, frame) : spot);
  }
  return result;
}

// Left and right in turn, pairs above each other.
std::vector<Spot> at_sides(int count, const Vec3& size, const Frame& frame) {
  const int levels = (count + 1) / 2;
  const double rise = frame.core.size().z() / levels;
  std::vector<Spot> result;
  for (int i = 0; i < count; ++i) {
    const bool left = count > 1 && i % 2 == 0;
    const double x = left ? frame.core.low.x() - 0.5 * size.x() + joint
                          : frame.core.high.x() + 0.5 * size.x() - joint;
    const double z = frame.core.low.z() + (i / 2 + 0.5) * rise - 0.5 * size.z();
    result.push_back({{x, frame.core.center().y(), std::max(0.0, z)}, {0, 0, left ? pi : 0.0}, size});
  }
  return result;
}

std::vector<Spot> behind(int count, const Vec3& size, const Frame& frame) {
  std::vector<Spot> result;
  const double width = size.x() / count;
  for (int i = 0; i < count; ++i) {
    const double x = frame.deck.center().x() + size.x() * ((i + 0.5) / count - 0.5);
    result.push_back({{x, frame.deck.high.y() - 0.5 * size.y(), frame.deck.high.z() - joint},
                      Vec3::Zero(),
                      {count > 1 ? (1 - gap_share) * width : width, size.y(), size.z()}});
  }
  return result;
}

std::vector<Spot> upon(int count, const Vec3& size, const Frame& frame, const Series& series) {
  const Vec3 room = frame.deck.size();
  const double fit =
      count > 1 ? std::min(1.0, (1 - gap_share) * room.x() / (count * size.x())) : 1.0;
  std::vector<Spot> result;
  for (int i = 0; i < count; ++i) {
    const double x = frame.deck.center().x() + room.x() * ((i + 0.5) / count - 0.5);
    result.push_back({{x, frame.deck.center().y(), frame.deck.high.z() - joint},
                      Vec3::Zero(),
                      {fit * size.x(), count > 1 ? std::min(size.y(), room.y()) : size.y(), size.z()}});
    vary(result.back(), i, series);
  }
  return result;
}

std::vector<Spot> hanging(int count, const Vec3& size, const Frame& frame) {
  std::vector<Spot> result;
  const double z = frame.low + 0.35 * (frame.high - frame.low);
  for (int i = 0; i < count; ++i) {
    const double reach = 0.5 * (frame.size.x() - size.x());
    const double x = count == 1 ? 0.0 : reach * (2 * share(i, count) - 1);
    result.push_back({{x, 0, z}, Vec3::Zero(), size});
  }
  return result;
}

}  // namespace

std::vector<Spot> spots(Place place, int count, const Vec3& size, const Frame& frame,
                        const Series& series, bool spread) {
  if (count < 1) return {};
  switch (place) {
    case Place::foot: return feet(count, size, frame);
    case Place::base: return slabs(count, size, series);
    case Place::deck: return boards(count, size, frame, series);
    case Place::column: return columns(count, size, frame);
    case Place::upright: return uprights(count, size, frame);
    case Place::across: return bars(count, size, frame);
    case Place::stack: return pile(count, size, frame, series);
    case Place::helix: return winding(count, size, frame);
    case Place::radial: return rays(count, size, frame, spread);
    case Place::wheel: return blades(count, size, frame);
    case Place::around: return circle(count, size, frame);
    case Place::front: return on_front(count, size, frame, series);
    case Place::side: return at_sides(count, size, frame);
    case Place::back: return behind(count, size, frame);
    case Place::top: return upon(count, size, frame, series);
    case Place::hang: return hanging(count, size, frame);
  }
  return {};
}

}  // namespace roomgen::create
