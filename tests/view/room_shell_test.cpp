#include "scene/room_shell.h"

#include <Eigen/Geometry>
#include <algorithm>
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
  cover_named(room.materials, accent_name).finish = "navy wall";
  for (const auto& part : room_shell(room)) {
    if (!part.name.starts_with("wall-")) continue;
    const bool dark = part.model.materials[0].base_color[0] < 0.3f;
    CHECK(dark == (part.name == "wall-1"));
  }
}

namespace {

// Area of a part's faces towards the room between two heights, of a material.
double area_towards(const ShellPart& part, const Vec2& inward, const std::array<float, 4>& color, double low, double high) {
  double area = 0.0;
  for (const auto& piece : part.model.parts) {
    if (part.model.materials[static_cast<std::size_t>(piece.material)].base_color != color) continue;
    for (const auto& t : piece.mesh.triangles) {
      const Vec3 a = piece.mesh.positions[t[0]].cast<double>(), b = piece.mesh.positions[t[1]].cast<double>(),
                 c = piece.mesh.positions[t[2]].cast<double>();
      const Vec3 twice = (b - a).cross(c - a);
      const double z = (a.z() + b.z() + c.z()) / 3.0;
      if (twice.norm() > 1e-9 && twice.normalized().head<2>().dot(inward) > 0.99 && z > low && z < high)
        area += 0.5 * twice.norm();
    }
  }
  return area;
}

}  // namespace

TEST_CASE("every wall has the finish that is said of it, and its lower part another") {
  Room room = test::plain_room();
  room.openings.clear();
  const std::vector<Eigen::Vector3f> colors = {{200, 10, 10}, {10, 200, 10}, {10, 10, 200}, {200, 200, 10}};
  const std::array<std::string, 4> words = {"#c80a0a", "#0ac80a", "#0a0ac8", "#c8c80a"};
  const std::array<std::string, 4> walls = {"south", "wall-1", "north", "west"};
  for (std::size_t k = 0; k < 4; ++k) room.materials.covers.push_back({walls[k], words[k], {}});
  room.materials.covers.insert(room.materials.covers.begin(), WallCover{"", "", WallBand{"#0a0a0a", 1.1}});
  room.materials.covers[2].lower = WallBand{"", 0.0};  // wall 1 has none
  ShellOptions options;
  options.skirting = false;
  for (const auto& part : room_shell(room, options)) {
    if (!part.name.starts_with("wall-")) continue;
    INFO(part.name);
    const std::size_t k = std::stoul(part.name.substr(5));
    const Vec2 inward = room.polygon.inward(k);
    const double length = room.polygon.edge(k).length(), height = room.height;
    const double band = k == 1 ? 0.0 : 1.1;
    CHECK(area_towards(part, inward, material_color(colors[k]), 0.0, height) == Approx(length * (height - band)));
    CHECK(area_towards(part, inward, material_color({10, 10, 10}), 0.0, band + 1e-6) == Approx(length * band));
    CHECK(measure(part.model).volume > 0.0);
    CHECK(measure(part.model).area_vector.norm() < 1e-6);  // closed
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
  const auto color = wall_coat(room, 0).upper.material.base_color;
  CHECK(color[1] > color[0]);
  CHECK(color[1] > color[2]);
}

namespace {

// Upright strips of random height: every one a shape that a hole may have.
std::vector<Vec2> random_outline(Random& random) {
  std::vector<Vec2> lower, upper;
  const int strips = random.integer(1, 6);
  for (int i = 0; i <= strips; ++i) {
    const double x = static_cast<double>(i) / strips;
    lower.emplace_back(x, random.uniform(0.0, 0.35));
    upper.emplace_back(x, random.uniform(0.65, 1.0));
  }
  if (random.chance(0.3)) lower.back().y() = upper.back().y() = 0.5;  // ends in a point
  std::reverse(upper.begin(), upper.end());
  lower.insert(lower.end(), upper.begin(), upper.end());
  if (lower[static_cast<std::size_t>(strips)] == lower[static_cast<std::size_t>(strips) + 1])
    lower.erase(lower.begin() + strips);
  return lower;
}

double volume_of(const std::vector<ShellPart>& shell, const std::string& name) {
  for (const auto& part : shell)
    if (part.name == name) return measure(part.model).volume;
  return 0.0;
}

// A mesh of its own for every corner of a box, its front half of another depth.
Model wedge(const Vec3& size) {
  Model model = test::colored_box(size, {200, 0, 0});
  append(model.parts[0].mesh, make_box({0.3 * size.x(), -0.5 * size.y() - 0.05, 0.4 * size.z()},
                                       {0.4 * size.x(), -0.5 * size.y(), 0.5 * size.z()}));
  return model;
}

Opening with_joinery(Opening opening, ModelTable& models, const Model& model) {
  opening.joinery.asset.library = "test";
  opening.joinery.asset.id = opening.id;
  models.add(asset_key(opening.joinery.asset), std::make_shared<Model>(model));
  return opening;
}

Model part(const std::vector<ShellPart>& shell, const std::string& name) {
  for (const auto& one : shell)
    if (one.name == name) return one.model;
  FAIL("no part " << name);
  return {};
}

}  // namespace

TEST_CASE("Holes have their outlines, in walls of any height") {
  Random random(23);
  for (int round = 0; round < 60; ++round) {
    Room room = test::plain_room();
    Opening& window = room.openings[1];
    window.outline = random_outline(random);
    REQUIRE(is_opening_outline(window.outline));
    ShellOptions options = bare();
    const auto whole = room_shell(room, options);
    const double hole = signed_area(outline(window));
    Room blind = room;
    blind.openings.pop_back();
    const double solid = volume_of(room_shell(blind, options), "wall-2");
    CHECK(volume_of(whole, "wall-2") == Approx(solid - hole * wall_thickness).epsilon(1e-5));
    CHECK(measure(part(whole, "wall-2")).area_vector.norm() < 1e-5);
    // Rays where the outline says so.
    for (int ray = 0; ray < 20; ++ray) {
      const Vec2 at(random.uniform(0.9, 3.1), random.uniform(0.8, 2.2));  // along the wall, up
      const Vec2 from_edge = at - Vec2(window.from, window.sill);
      const Polygon shape{outline(window)};
      if (distance_to_boundary(shape, at) < 1e-3) continue;
      INFO("at " << from_edge.x() << ", " << from_edge.y());
      CHECK(hits(part(whole, "wall-2"), {4 - at.x(), 2, at.y()}, {4 - at.x(), 4, at.y()}) !=
            contains(shape, at));
    }
    // Cut at any height the wall stays a closed solid.
    options.wall_heights = {2.7, 2.7, random.uniform(0.1, 2.6), 2.7};
    CHECK(measure(part(room_shell(room, options), "wall-2")).area_vector.norm() < 1e-5);
  }
}

TEST_CASE("The woodwork of every kind of opening stays in its hole and is closed") {
  Random random(29);
  for (int round = 0; round < 80; ++round) {
    Room room = test::plain_room();
    Opening& door = room.openings[0];
    door.to = door.from + random.uniform(0.7, 2.6);
    door.leaves = random.integer(1, 2);
    door.glazed = random.chance(0.5);
    door.swing = random.chance(0.3) ? DoorSwing::sliding : DoorSwing::in;
    door.hinge_at_from = random.chance(0.5);
    if (random.chance(0.3)) door.type = OpeningType::passage;
    if (random.chance(0.5))
      door.outline = {{0, 0}, {1, 0}, {1, 0.7}, {0.8, 0.95}, {0.5, 1}, {0.2, 0.95}, {0, 0.7}};
    if (random.chance(0.5))
      room.openings[1].outline = {{0.5, 0}, {0.9, 0.2}, {1, 0.5}, {0.8, 0.9},
                                  {0.5, 1}, {0.1, 0.8}, {0, 0.5}, {0.1, 0.2}};
    ShellOptions options;
    if (random.chance(0.4))
      options.wall_heights = {random.uniform(0.2, 2.6), 2.7, random.uniform(0.2, 2.6), 2.7};
    for (const auto& one : room_shell(room, options)) {
      if (one.name != "door-0" && one.name != "window-0") continue;
      const Opening& opening = *find_opening(room, one.name);
      const Segment line = segment(room, opening);
      const double top = opening.wall < options.wall_heights.size()
                             ? std::min(opening.head, options.wall_heights[opening.wall])
                             : opening.head;
      const Bounds3 box = bounds(one.model);
      INFO(one.name);
      CHECK(box.low.x() >= std::min(line.a.x(), line.b.x()) - 1e-5);
      CHECK(box.high.x() <= std::max(line.a.x(), line.b.x()) + 1e-5);
      CHECK(box.low.z() >= opening.sill - 1e-5);
      CHECK(box.high.z() <= top + 1e-5);
      CHECK(measure(one.model).area_vector.norm() < 1e-4);
      CHECK(measure(one.model).volume > 0);
    }
  }
}

TEST_CASE("A mesh fills its hole, as deep in the wall as the wall") {
  for (const bool window : {false, true})
    for (const bool outward : {false, true}) {
      Room room = test::plain_room();
      ModelTable models;
      Opening& opening = room.openings[window ? 1 : 0];
      if (outward && !window) opening.swing = DoorSwing::out;
      opening = with_joinery(opening, models, wedge({0.8, 0.3, 1.9}));
      opening.joinery.wall_front = 0.05;  // behind what stands out
      opening.joinery.wall_back = 0.35;
      const Model shown = part(room_shell(room, {}, models), opening.id);
      const Bounds3 box = bounds(shown);
      const Segment line = segment(room, opening);
      CHECK(box.low.x() == Approx(std::min(line.a.x(), line.b.x())));
      CHECK(box.high.x() == Approx(std::max(line.a.x(), line.b.x())));
      CHECK(box.low.z() == Approx(opening.sill).margin(1e-6));
      CHECK(box.high.z() == Approx(opening.head));
      // What stands out is in the room, or outside for a door that opens outward.
      const double out = -inward(room, opening).y(), face = line.a.y();
      const bool front_outside = outward && !window;
      const double low = out > 0 ? face - (front_outside ? 0 : 0.05)
                                 : face - wall_thickness - (front_outside ? 0.05 : 0);
      CHECK(box.low.y() == Approx(low).margin(1e-6));
      CHECK(box.size().y() == Approx(wall_thickness + 0.05));
      CHECK(measure(shown).volume > 0);  // not turned inside out
    }
}

TEST_CASE("A mirrored door has its handle at the other side, and is not inside out") {
  double handle[2];
  for (const bool mirrored : {false, true}) {
    Room room = test::plain_room();
    ModelTable models;
    Opening& door = room.openings[0];
    door = with_joinery(door, models, wedge({0.9, 0.3, 2.05}));
    door.joinery.wall_front = 0.05;
    door.joinery.wall_back = 0.35;
    door.joinery.mirrored = mirrored;
    const Model shown = part(room_shell(room, {}, models), "door-0");
    CHECK(measure(shown).volume > 0);
    for (const auto& p : shown.parts[0].mesh.positions)
      if (p.y() > 0.04f) handle[mirrored] = p.x();
  }
  const double middle = 0.5 * (0.5 + 1.4);
  // At the model's right, as seen from the room, which looks along -y here: lower x.
  CHECK(handle[0] < middle);
  CHECK(handle[1] > middle);
}

TEST_CASE("Side by side, meshes share the width, a cut wall and a missing model have woodwork") {
  Room room = test::plain_room();
  ModelTable models;
  Opening& window = room.openings[1];
  window = with_joinery(window, models, test::colored_box({0.7, 0.1, 1.2}, {0, 200, 0}));
  window.joinery.side_by_side = 3;
  const Model shown = part(room_shell(room, {}, models), "window-0");
  REQUIRE(shown.parts.size() == 3);
  CHECK(bounds(shown).size().x() == Approx(window.width()));
  for (const auto& piece : shown.parts)
    CHECK(bounds(piece.mesh).size().x() == Approx(window.width() / 3));
  ShellOptions cut;
  cut.wall_heights = {2.7, 2.7, 1.5, 2.7};
  CHECK(bounds(part(room_shell(room, cut, models), "window-0")).high.z() <= 1.5 + 1e-6);
  CHECK(part(room_shell(room, {}, {}), "window-0").parts.size() == 2);  // frame and pane
}
