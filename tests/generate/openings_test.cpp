// Doors and windows get meshes, and what hangs at windows hangs there.
#include <set>

#include "catch.h"
#include "collision/usability.h"
#include "fit_openings.h"
#include "roomgen/create/create.h"
#include "roomgen/design/designer.h"
#include "roomgen/evaluate/report.h"
#include "roomgen/generate/generate.h"
#include "support/furnished_room.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

/// A library of doors and windows, all found by their tags.
class Shop final : public AssetLibrary {
 public:
  void add(const std::string& id, const std::string& category, const std::string& tag,
           const Vec3& size, WallFit fit) {
    AssetInfo info;
    info.ref.library = "Shop";
    info.ref.id = id;
    info.category = category;
    info.tags = {tag};
    info.size = size;
    info.wall_fit = std::move(fit);
    assets_.push_back(info);
  }

  Result<std::vector<AssetMatch>> search(const AssetQuery& query) const override {
    std::vector<AssetMatch> matches;
    for (const auto& asset : assets_)
      if (asset.category == query.category) matches.push_back({asset, 1.0});
    return matches;
  }
  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override {
    for (const auto& asset : assets_)
      if (asset.ref.id == ref.id)
        return std::make_shared<const Model>(test::colored_box(asset.size, {120, 80, 60}));
    return Error{Error::Kind::not_found, ref.id};
  }

 private:
  std::vector<AssetInfo> assets_;
};

WallFit hinged(int leaves, bool hinge_left = false) {
  WallFit fit;
  fit.wall_front = 0.04;
  fit.wall_back = 0.12;
  fit.leaves = leaves;
  fit.hinge_left = hinge_left;
  return fit;
}

Shop shop() {
  Shop result;
  result.add("door", "door", "interior", {0.9, 0.16, 2.1}, hinged(1));
  result.add("double", "door", "double", {1.7, 0.16, 2.1}, hinged(2));
  result.add("casement", "window", "casement", {1.1, 0.3, 1.3}, hinged(2));
  result.add("french", "window", "french", {1.1, 0.3, 2.2}, hinged(2));
  WallFit arch = hinged(2);
  arch.outline = {{0, 0}, {1, 0}, {1, 0.7}, {0.3, 1}, {0, 0.7}};
  result.add("arched", "window", "arched", {1.1, 0.3, 2.2}, arch);
  result.add("no fit", "door", "interior", {0.9, 0.16, 2.1}, hinged(1));
  return result;
}

Room room_with(std::vector<Opening> openings) {
  Room room = rooms::box(6, 5);
  room.openings = std::move(openings);
  REQUIRE(check(room));
  return room;
}

void fit(Room& room, std::uint64_t seed = 0) {
  const auto used = fit_openings(room, *OpeningKinds::built_in(), shop(), Random(seed));
  REQUIRE(used);
  CHECK(check(room));
}

Opening double_door(double width) {
  Opening door = rooms::door("door-0", 0, 1, 1 + width);
  door.kind = "double door";
  door.leaves = 2;
  return door;
}

}  // namespace

TEST_CASE("A mesh is taken when it fits: its leaves, its outline, and fair stretching") {
  Room room = room_with({double_door(1.6), rooms::window("window-0", 2, 1, 2)});
  fit(room);
  CHECK(room.openings[0].joinery.asset.id == "double");
  CHECK(room.openings[1].joinery.asset.id == "casement");
  CHECK(room.openings[0].joinery.wall_front == 0.04);
  // Too wide for any, even stretched.
  room = room_with({double_door(3.2)});
  fit(room);
  CHECK(room.openings[0].joinery.asset.is_box());
  // Too low for any.
  Opening strip = rooms::window("window-0", 2, 1, 2);
  strip.sill = 1.7;
  room = room_with({strip});
  fit(room);
  CHECK(room.openings[0].joinery.asset.is_box());
}

TEST_CASE("Wide windows are several side by side, none stretched beyond what is fair") {
  Random random(2);
  int fitted = 0;
  for (int i = 0; i < 60; ++i) {
    const double width = random.uniform(0.5, 5.5);
    Room room = room_with({rooms::window("window-0", 2, 0.2, 0.2 + width)});
    fit(room);
    const Joinery& joinery = room.openings[0].joinery;
    if (joinery.asset.is_box()) continue;
    ++fitted;
    const double stretch = width / joinery.side_by_side / 1.1;
    CHECK(stretch >= 0.75);
    CHECK(stretch <= 1.3);
  }
  CHECK(fitted > 45);
}

TEST_CASE("A door hangs on its hinge whichever way it opens") {
  // The mesh's hinge is at the right of who looks at its front, which looks where the door opens.
  // From inside, the wall's beginning is at the right; from outside it is at the left.
  for (const bool at_from : {true, false})
    for (const auto swing : {DoorSwing::in, DoorSwing::out}) {
      Opening door = rooms::door("door-0", 0, 1, 1.9);
      door.hinge_at_from = at_from;
      door.swing = swing;
      Room room = room_with({door});
      fit(room);
      REQUIRE_FALSE(room.openings[0].joinery.asset.is_box());
      const bool hinge_at_right = swing == DoorSwing::in ? at_from : !at_from;
      CHECK(room.openings[0].joinery.mirrored == !hinge_at_right);
    }
}

TEST_CASE("A window takes the outline of its mesh, seen from the other side") {
  Opening window = rooms::window("window-0", 2, 1, 2);
  window.kind = "arched window";
  window.sill = 0.3;
  window.head = 2.4;
  window.outline = {{0, 0}, {1, 0}, {1, 0.8}, {0.5, 1}, {0, 0.8}};
  Room room = room_with({window});
  fit(room);
  REQUIRE(room.openings[0].joinery.asset.id == "arched");
  double peak = 0.0;
  for (const auto& p : room.openings[0].outline)
    if (p.y() == 1.0) peak = p.x();
  CHECK(peak == Approx(0.7));
}

TEST_CASE("What has a mesh keeps it, and equal seeds choose equal meshes") {
  Opening door = rooms::door("door-0", 0, 1, 1.9);
  door.joinery.asset.library = "Elsewhere";
  door.joinery.asset.id = "old";
  Room room = room_with({door});
  fit(room);
  CHECK(room.openings[0].joinery.asset.id == "old");
  std::set<std::string> ids;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Room one = room_with({rooms::door("door-0", 0, 1, 1.9), rooms::door("door-1", 1, 1, 1.9)}),
         other = one;
    fit(one, seed);
    fit(other, seed);
    CHECK(one.openings[0].joinery.asset == other.openings[0].joinery.asset);
    CHECK(one.openings[0].joinery.asset == one.openings[1].joinery.asset);
    ids.insert(one.openings[0].joinery.asset.id);
  }
  CHECK(ids.size() == 2);  // both that fit equally well are chosen by some seed
}

namespace {

Generation furnished(const std::string& prompt, std::uint64_t seed) {
  const auto designer = make_rule_designer();
  PlanRequest request;
  request.prompt = prompt;
  request.seed = seed;
  const auto plan = designer->plan(request);
  REQUIRE(plan);
  const auto library = create::make_created_library();
  BuildOptions options;
  options.seed = seed;
  auto generation = generate(*plan, *designer, *library, KindTable::built_in(), options);
  REQUIRE(generation);
  return *std::move(generation);
}

bool crosses(const Object& object, const Room& room, const Opening& opening) {
  const Segment wall = room.polygon.edge(opening.wall);
  double low = 1e9, high = -1e9, off = 1e9;
  const Footprint base = footprint(object);
  for (const auto& corner : base.outline()) {
    low = std::min(low, (corner - wall.a).dot(wall.direction()));
    high = std::max(high, (corner - wall.a).dot(wall.direction()));
    off = std::min(off, (corner - wall.a).dot(room.polygon.inward(opening.wall)));
  }
  return off < 0.05 && low < opening.to - 1e-3 && high > opening.from + 1e-3 &&
         bottom(object) < opening.head - 1e-3 && top(object) > opening.sill + 1e-3;
}

}  // namespace

TEST_CASE(
    "Curtains and blinds hang before the middle of a window, from above it to floor or sill") {
  const auto& table = KindTable::built_in();
  int hung = 0, left_out = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed)
    for (const char* prompt :
         {"a bedroom with three windows and curtains", "an office with two windows and blinds",
          "a small living room with a desk by the window and curtains"}) {
      const Generation generation = furnished(prompt, seed);
      const Scene& scene = generation.scene;
      INFO(prompt << ", seed " << seed);
      for (const auto& object : scene.objects) {
        if (!table.get(object.category).covers_window) continue;
        ++hung;
        int covered = 0;
        for (const auto& opening : scene.room.openings) {
          if (!crosses(object, scene.room, opening)) continue;
          REQUIRE(opening.type == OpeningType::window);
          ++covered;
          const Vec2 middle = segment(scene.room, opening).middle();
          const Vec2 away = object.position.head<2>() - middle;
          CHECK(std::abs(cross(away, inward(scene.room, opening))) < 1e-3);
          CHECK(object.size.x() >= opening.width());
          CHECK(top(object) >= std::min(opening.head, scene.room.height - 0.1));
          // To the floor, the sill, or drawn up to the middle.
          CHECK(bottom(object) <= 0.5 * (opening.sill + opening.head) + 1e-3);
          CHECK(bottom(object) >= 0.0);
        }
        CHECK(covered == 1);
      }
      for (const auto& missing : scene.unplaced) {
        if (!table.get(missing.category).covers_window) continue;
        ++left_out;
        CHECK_FALSE(missing.reason.empty());
      }
      const auto report = examine(scene, generation.models, table);
      CHECK(report.violations.empty());
    }
  // Left out only where tall things stand before a window.
  CHECK(hung >= 20);
  CHECK(4 * left_out < hung);
}

TEST_CASE("Nothing else on a wall crosses a door or a window, nor reaches into furniture") {
  const auto& table = KindTable::built_in();
  int on_walls = 0;
  for (std::uint64_t seed = 0; seed < 3; ++seed)
    for (const char* prompt :
         {"a living room with four pictures, two wall shelves, a wall clock and three windows",
          "a bedroom with two wardrobes, three pictures, a mirror and double doors",
          "a kitchen with wall cabinets, a clock, a round window and a sliding glass door"}) {
      const Generation generation = furnished(prompt, seed);
      INFO(prompt << ", seed " << seed);
      for (const auto& object : generation.scene.objects) {
        if (object.mount != Mount::wall || table.get(object.category).covers_window) continue;
        ++on_walls;
        for (const auto& opening : generation.scene.room.openings) {
          INFO(object.id << " at " << opening.id);
          CHECK_FALSE(crosses(object, generation.scene.room, opening));
        }
      }
      // Tall furniture too: solids do not overlap, and doors stay free and connected.
      CHECK(examine(generation.scene, generation.models, table).violations.empty());
    }
  CHECK(on_walls > 20);
}

TEST_CASE("All doors are connected and all things in reach, whatever the doors are") {
  for (const char* prompt :
       {"a bedroom with double doors on the left wall and a door on the right wall",
        "a living room with a sliding glass door, an archway and french doors",
        "a dining room with a passage opposite the door",
        "a garage with a garage door and a front door"})
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const Generation generation = furnished(prompt, seed);
      INFO(prompt << ", seed " << seed);
      const auto& table = KindTable::built_in();
      const auto things = floor_things(generation.scene.objects, table);
      const OccupancyGrid map = make_occupancy_grid(generation.scene.room, things);
      CHECK(map.doors_connected());
      for (const auto& thing : things) {
        INFO(thing.object->id);
        CHECK(is_usable(generation.scene.room, things, thing, map));
      }
      CHECK(examine(generation.scene, generation.models, table).violations.empty());
    }
}
