#include "roomgen/scene/room_shell.h"

#include <Eigen/Geometry>
#include <map>

#include "catch.h"
#include "support/furnished_room.h"

using namespace roomgen;

namespace {

ShellOptions bare() {
  ShellOptions options;
  options.skirting = options.window_frames = options.door_frames = options.door_leaves = false;
  options.ceiling = false;
  return options;
}

struct Solid {
  double volume = 0.0;           ///< by the divergence theorem: only right if it is closed
  Vec3 area_vector = {0, 0, 0};  ///< zero if it is closed
};

Solid measure(const Model& model) {
  Solid solid;
  for (const auto& part : model.parts)
    for (const auto& t : part.mesh.triangles) {
      const Vec3 a = part.mesh.positions[t[0]].cast<double>(),
                 b = part.mesh.positions[t[1]].cast<double>(),
                 c = part.mesh.positions[t[2]].cast<double>();
      solid.volume += a.dot(b.cross(c)) / 6.0;
      solid.area_vector += 0.5 * (b - a).cross(c - a);
    }
  return solid;
}

// Floor area under the walls, corner by corner: a strip along each edge, and at each corner a kite
// that is added where the room is convex and missing where it is not.
double wall_plan_area(const Room& room) {
  double area = 0.0;
  const auto& p = room.polygon.points;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Vec2 in = p[k] - p[(k + p.size() - 1) % p.size()], out = p[(k + 1) % p.size()] - p[k];
    const double turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
    area += out.norm() * wall_thickness + wall_thickness * wall_thickness * std::tan(0.5 * turn);
  }
  return area;
}

double expected_wall_volume(const Room& room) {
  double volume = wall_plan_area(room) * room.height;
  for (const auto& o : room.openings)
    volume -= (o.to - o.from) * (o.head - o.sill) * wall_thickness;
  return volume;
}

// Moeller and Trumbore's test: does the segment from a to b meet the model?
bool hits(const Model& model, const Vec3& from, const Vec3& to) {
  const Vec3 direction = to - from;
  for (const auto& part : model.parts)
    for (const auto& t : part.mesh.triangles) {
      const Vec3 a = part.mesh.positions[t[0]].cast<double>();
      const Vec3 e1 = part.mesh.positions[t[1]].cast<double>() - a,
                 e2 = part.mesh.positions[t[2]].cast<double>() - a;
      const Vec3 p = direction.cross(e2);
      const double determinant = e1.dot(p);
      if (std::abs(determinant) < 1e-12) continue;
      const Vec3 s = from - a, q = s.cross(e1);
      const double u = s.dot(p) / determinant, v = direction.dot(q) / determinant,
                   d = e2.dot(q) / determinant;
      if (u >= 0 && v >= 0 && u + v <= 1 && d >= 0 && d <= 1) return true;
    }
  return false;
}

bool hits(const std::vector<ShellPart>& shell, const Vec3& from, const Vec3& to) {
  return std::any_of(shell.begin(), shell.end(),
                     [&](const ShellPart& part) { return hits(part.model, from, to); });
}

Room slanted_room() {
  Room room;
  room.polygon.points = {{0, 0}, {5, 0.5}, {4, 4}, {1, 3}};
  room.openings = {test::opening("door-0", 0, 1.0, 1.9), test::opening("window-0", 2, 0.5, 1.5),
                   test::opening("window-1", 2, 1.5, 2.5)};
  return room;
}

}  // namespace

TEST_CASE("walls are closed solids of the volume that their plan says, less the openings") {
  for (const auto& room : {test::plain_room(), test::l_shaped_room(), slanted_room()}) {
    double volume = 0.0;
    for (const auto& part : room_shell(room, bare())) {
      const Solid solid = measure(part.model);
      INFO(part.name);
      CHECK(solid.area_vector.norm() < 1e-5);
      if (part.name != "floor") volume += solid.volume;
    }
    CHECK(volume == Approx(expected_wall_volume(room)).epsilon(1e-5));
  }
}

TEST_CASE("the floor reaches under the walls, its upper face at zero") {
  const Room room = test::plain_room();
  const auto shell = room_shell(room, bare());
  REQUIRE(shell.front().name == "floor");
  const Bounds3 box = bounds(shell.front().model);
  CHECK(box.low.x() == Approx(-0.1));
  CHECK(box.high.y() == Approx(3.1));
  CHECK(std::abs(box.high.z()) < 1e-9);
  CHECK(measure(shell.front().model).volume == Approx(4.2 * 3.2 * floor_thickness).epsilon(1e-5));
}

TEST_CASE("one can walk through a door and look through a window, not through a wall") {
  const Room room = test::plain_room();
  const auto shell = room_shell(room, bare());
  CHECK_FALSE(hits(shell, {0.95, 1, 1.0}, {0.95, -1, 1.0}));  // through the door
  CHECK_FALSE(hits(shell, {0.55, 1, 2.0}, {0.55, -1, 2.0}));  // near its upper corner
  CHECK(hits(shell, {0.95, 1, 2.1}, {0.95, -1, 2.1}));        // above it
  CHECK(hits(shell, {1.5, 1, 1.0}, {1.5, -1, 1.0}));          // beside it
  CHECK_FALSE(hits(shell, {2.0, 2, 1.5}, {2.0, 4, 1.5}));     // through the window
  CHECK(hits(shell, {2.0, 2, 0.5}, {2.0, 4, 0.5}));           // below it
  CHECK_FALSE(hits(shell, {2.0, 2, 2.8}, {2.0, 4, 2.8}));     // over the wall
}

TEST_CASE("a closed door stops who walks, a pane stops who climbs") {
  const auto shell = room_shell(test::plain_room());
  CHECK(hits(shell, {0.95, 1, 1.0}, {0.95, -1, 1.0}));
  CHECK(hits(shell, {1.5, 2, 1.5}, {1.5, 4, 1.5}));
}

TEST_CASE("normals agree with the winding of their triangles") {
  for (const auto& part : room_shell(slanted_room()))
    for (const auto& piece : part.model.parts)
      for (const auto& t : piece.mesh.triangles) {
        const Eigen::Vector3f face =
            (piece.mesh.positions[t[1]] - piece.mesh.positions[t[0]])
                .cross(piece.mesh.positions[t[2]] - piece.mesh.positions[t[0]]);
        CHECK(face.dot(piece.mesh.normals[t[0]]) >= 0.0f);
      }
}

TEST_CASE("the inner faces have the area of the walls less the openings") {
  Room room = test::plain_room();
  room.polygon.points = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  const auto shell = room_shell(room, bare());
  double area = 0.0;
  for (const auto& part : shell)
    for (const auto& piece : part.model.parts)
      for (const auto& t : piece.mesh.triangles) {
        const Vec3 a = piece.mesh.positions[t[0]].cast<double>(),
                   b = piece.mesh.positions[t[1]].cast<double>(),
                   c = piece.mesh.positions[t[2]].cast<double>();
        const Vec3 middle = (a + b + c) / 3.0;
        const bool inner = part.name == "wall-0" && std::abs(middle.y()) < 1e-6 &&
                           std::abs((b - a).cross(c - a).normalized().y()) > 0.9;
        if (inner) area += 0.5 * (b - a).cross(c - a).norm();
      }
  CHECK(area == Approx(4 * 2.7 - 0.9 * 2.05).epsilon(1e-5));
}

TEST_CASE("a cut wall ends at the cut, its openings and woodwork with it") {
  const Room room = test::plain_room();
  ShellOptions options;
  options.ceiling = false;
  options.wall_heights.assign(4, 1.2);
  for (const auto& part : room_shell(room, options)) {
    INFO(part.name);
    CHECK(bounds(part.model).high.z() <= 1.2 + 1e-6);
  }
  const auto shell = room_shell(room, options);
  CHECK_FALSE(hits(shell, {2.0, 2, 1.3}, {2.0, 4, 1.3}));
}

TEST_CASE("an opening beside an inner corner stays within its wall") {
  Room room = test::l_shaped_room();
  room.openings = {test::opening("door-0", 2, 1.1, 2.0)};  // ends at the corner (4, 3)
  for (const auto& part : room_shell(room, bare()))
    for (const auto& piece : part.model.parts)
      for (const auto& p : piece.mesh.positions) CHECK(p.allFinite());
}

TEST_CASE("the ceiling covers room and walls, and is seen from below alone") {
  for (const auto& room : {test::plain_room(), test::l_shaped_room(), slanted_room()}) {
    const auto shell = room_shell(room);
    const auto ceiling = std::find_if(shell.begin(), shell.end(),
                                      [](const ShellPart& part) { return part.name == "ceiling"; });
    REQUIRE(ceiling != shell.end());
    const Bounds3 box = bounds(ceiling->model);
    CHECK(box.low.z() == Approx(room.height));
    CHECK(box.high.z() == Approx(room.height));
    // As large as the room with its walls, all of it facing down.
    const Vec3 facing = measure(ceiling->model).area_vector;
    CHECK(facing.z() == Approx(-(area(room.polygon) + wall_plan_area(room))).epsilon(1e-5));
    for (const auto& material : ceiling->model.materials) CHECK_FALSE(material.double_sided);
    const Bounds2 floor = bounds(room.polygon);
    for (double x = floor.low.x(); x <= floor.high.x(); x += 0.21)
      for (double y = floor.low.y(); y <= floor.high.y(); y += 0.23)
        if (contains(room.polygon, Vec2(x, y)))
          CHECK(hits(ceiling->model, {x, y, 0.1}, {x, y, room.height + 0.1}));
  }
}

TEST_CASE("one wall may differ from the others") {
  Room room = test::plain_room();
  CHECK(accent_wall(room) == 1);  // no longer one without an opening
  room.materials.walls = "white walls";
  room.materials.accent = "navy wall";
  for (const auto& part : room_shell(room)) {
    if (!part.name.starts_with("wall-")) continue;
    const bool dark = part.model.materials[0].base_color[0] < 0.3f;
    CHECK(dark == (part.name == "wall-1"));
  }
}

TEST_CASE("words choose floors and walls, the room's type the rest") {
  Room room = test::plain_room();
  const auto same = [](const Finish& a, const Finish& b) {
    return a.material.texture->pixels == b.material.texture->pixels;
  };
  room.materials.floor = "dark walnut planks";
  const Finish walnut = floor_finish(room);
  room.materials.floor = "white tiles";
  const Finish tiles = floor_finish(room);
  CHECK_FALSE(same(walnut, tiles));
  CHECK(same(tiles, floor_finish(room)));
  room.materials.floor = "";
  room.type = "bathroom";
  CHECK(floor_finish(room).extent == tiles.extent);
  room.materials.walls = "sage green";
  const auto color = wall_finish(room).material.base_color;
  CHECK(color[1] > color[0]);
  CHECK(color[1] > color[2]);
}
