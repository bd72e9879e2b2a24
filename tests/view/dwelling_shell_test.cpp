// The shell of a dwelling: its walls and floors are there once.
#include <Eigen/Geometry>
#include <set>

#include "catch.h"
#include "scene/room_shell.h"

using namespace roomgen;

namespace {

struct Box {
  Vec2 low, high;
};

std::vector<Room> rooms_of(const std::vector<Box>& boxes) {
  std::vector<Room> rooms;
  for (const auto& box : boxes) {
    Room room;
    room.id = "room-" + std::to_string(rooms.size());
    room.height = 2.5;
    room.polygon.points = {box.low, {box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()}};
    rooms.push_back(room);
  }
  return rooms;
}

double volume_of(const Model& model) {
  double volume = 0.0;
  for (const auto& part : model.parts)
    for (const auto& t : part.mesh.triangles) {
      const Vec3 a = part.mesh.positions[t[0]].cast<double>(),
                 b = part.mesh.positions[t[1]].cast<double>(),
                 c = part.mesh.positions[t[2]].cast<double>();
      volume += a.dot(b.cross(c)) / 6.0;
    }
  return volume;
}

// Of the union of boxes that are larger by a margin, cell by cell between all their sides.
double union_area(const std::vector<Box>& boxes, double margin) {
  std::set<double> xs, ys;
  for (const auto& box : boxes) {
    xs.insert({box.low.x() - margin, box.high.x() + margin});
    ys.insert({box.low.y() - margin, box.high.y() + margin});
  }
  double area = 0.0;
  for (auto x = xs.begin(); std::next(x) != xs.end(); ++x)
    for (auto y = ys.begin(); std::next(y) != ys.end(); ++y) {
      const Vec2 middle(0.5 * (*x + *std::next(x)), 0.5 * (*y + *std::next(y)));
      for (const auto& box : boxes)
        if (middle.x() > box.low.x() - margin && middle.x() < box.high.x() + margin &&
            middle.y() > box.low.y() - margin && middle.y() < box.high.y() + margin) {
          area += (*std::next(x) - *x) * (*std::next(y) - *y);
          break;
        }
    }
  return area;
}

const std::vector<std::vector<Box>> plans = {
    {{{0, 0}, {4, 3}}},
    {{{0, 0}, {4, 3}}, {{4.1, 0}, {7, 3}}},                                            // side by side
    {{{0, 0}, {4, 3}}, {{4.1, -1}, {7, 2}}},                                           // shifted
    {{{0, 0}, {4, 3}}, {{4.1, 1}, {7, 2}}},                                            // shorter
    {{{0, 0}, {6, 1.4}}, {{0, 1.5}, {3, 5}}, {{3.1, 1.5}, {6, 5}}},                    // a T
    {{{0, 0}, {3, 3}}, {{3.1, 0}, {6, 3}}, {{0, 3.1}, {3, 6}}, {{3.1, 3.1}, {6, 6}}},  // a cross
    {{{0, 0}, {8, 1.4}}, {{0, 1.5}, {3, 5}}, {{3.1, 1.5}, {6, 5}}, {{0, -3.1}, {4, -0.1}},
     {{4.1, -3.1}, {8, -0.1}}}};

}  // namespace

TEST_CASE("The walls of a dwelling fill the floor between and around its rooms once") {
  ShellOptions options;
  options.skirting = options.window_frames = options.door_frames = options.door_leaves = options.ceiling = false;
  for (std::size_t plan = 0; plan < plans.size(); ++plan) {
    // In whatever order the rooms come.
    auto boxes = plans[plan];
    for (std::size_t turn = 0; turn < boxes.size(); ++turn) {
      std::rotate(boxes.begin(), boxes.begin() + 1, boxes.end());
      INFO("plan " << plan << " turned by " << turn);
      const auto rooms = rooms_of(boxes);
      double walls = 0.0, floors = 0.0, inner = 0.0;
      for (const auto& room : rooms) inner += area(room.polygon);
      for (std::size_t i = 0; i < rooms.size(); ++i)
        for (const auto& part : room_shell(rooms, i, options))
          (part.name == "floor" ? floors : walls) += volume_of(part.model);
      const double whole = union_area(boxes, wall_thickness);
      CHECK(walls == Approx((whole - inner) * 2.5).epsilon(1e-4));
      CHECK(floors == Approx(whole * floor_thickness).epsilon(1e-4));
    }
  }
}

TEST_CASE("A door between two rooms is one hole with one leaf") {
  auto rooms = rooms_of(plans[1]);
  Opening door;
  door.id = "door-0";
  door.wall = 1;
  door.from = 1.0;
  door.to = 1.9;
  door.leads_to = rooms[1].id;
  rooms[0].openings.push_back(door);
  door.wall = 3;
  door.from = 3.0 - 1.9;
  door.to = 3.0 - 1.0;
  door.leads_to = rooms[0].id;
  rooms[1].openings.push_back(door);
  ShellOptions bare;
  bare.skirting = bare.window_frames = bare.door_frames = bare.door_leaves = bare.ceiling = false;
  double walls = 0.0;
  int leaves = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    for (const auto& part : room_shell(rooms, i, bare))
      if (part.name != "floor") walls += volume_of(part.model);
    for (const auto& part : room_shell(rooms, i)) leaves += part.name == "door-0";
  }
  const double solid = (union_area(plans[1], wall_thickness) - union_area(plans[1], 0.0)) * 2.5;
  CHECK(walls == Approx(solid - 0.9 * door.head * wall_thickness).epsilon(1e-4));
  CHECK(leaves == 1);
}

TEST_CASE("A wall between two rooms is painted on each side as its room is") {
  auto rooms = rooms_of(plans[1]);
  rooms[0].materials.walls = "sage walls";
  rooms[1].materials.walls = "navy walls";
  // Triangles of the wall between that look into the second room.
  for (const auto& part : room_shell(rooms, 0)) {
    if (part.name != "wall-1") continue;
    const auto second = room_shell(rooms, 1);
    const Material& theirs = second[1].model.materials[0];
    bool painted = false;
    for (const auto& piece : part.model.parts)
      for (const auto& t : piece.mesh.triangles) {
        const auto& p = piece.mesh.positions;
        const bool outer = std::abs(p[t[0]].x() - 4.1f) < 1e-4f && std::abs(p[t[1]].x() - 4.1f) < 1e-4f &&
                           std::abs(p[t[2]].x() - 4.1f) < 1e-4f;
        const float middle = (p[t[0]].y() + p[t[1]].y() + p[t[2]].y()) / 3.0f;
        if (!outer || middle < 0.0f || middle > 3.0f) continue;
        painted = true;
        CHECK(part.model.materials[static_cast<std::size_t>(piece.material)].base_color ==
              theirs.base_color);
      }
    CHECK(painted);
  }
}
