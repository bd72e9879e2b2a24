// Finished rooms as designs: laid into the same room they give that room again, and in smaller and
// larger ones what stands at a wall still does.
#include "round_trip.h"

#include <algorithm>
#include <set>

using namespace roomgen;

namespace {

Scene scene_named(const std::string& name) {
  auto scene = read_scene(std::string(ROOMGEN_TEST_DATA) + "/learn/" + name + ".json");
  if (!scene) FAIL(scene.error().message);
  return *std::move(scene);
}

Json design_named(const std::string& name) {
  const auto design = learn_design(scene_named(name));
  if (!design) FAIL(design.error().message);
  return *design;
}

Vec2 size_of(const Scene& scene) {
  return bounds(scene.room.polygon).size();
}

// Of what stands on the floor, by the walls that its back is at.
std::multiset<std::string> at_walls(const std::vector<test::Spot>& spots, const Vec2& size) {
  std::multiset<std::string> found;
  for (const auto& spot : spots) {
    const Vec2 back = spot.at - 0.5 * spot.size.y() * front_direction(spot.yaw);
    const double distances[] = {back.y(), size.x() - back.x(), size.y() - back.y(), back.x()};
    for (int side = 0; side < 4; ++side)
      if (spot.mount == Mount::floor && std::abs(distances[side]) < 0.1)
        found.insert(spot.category + " at " + std::to_string(side));
  }
  return found;
}

const Json& group_with(const Json& design, const std::string& category) {
  for (const auto& group : design["groups"])
    if (group["things"].front()["name"] == category) return group;
  FAIL("no group of a " + category);
  return design;
}

}  // namespace

TEST_CASE("A room that became a design becomes the same room again") {
  const auto name = GENERATE(as<std::string>(), "twin-bedroom", "living-room", "call-centre");
  const Scene scene = scene_named(name);
  const auto result = test::compared(scene, test::plan_of(design_named(name), size_of(scene)));
  for (const auto& id : result.elsewhere) UNSCOPED_INFO(name << ": " << id << " is elsewhere");
  CHECK(static_cast<double>(result.elsewhere.size()) <= 0.1 * result.floor);
}

TEST_CASE(
    "What a design has at walls is there in smaller and larger rooms, and nothing is outside") {
  const auto name = GENERATE(as<std::string>(), "twin-bedroom", "living-room");
  const Json design = design_named(name);
  const Vec2 size = size_of(scene_named(name));
  const auto before = at_walls(test::spots_of(test::plan_of(design, size)), size);
  REQUIRE(before.size() > 3);
  for (const double scale : {0.85, 1.25}) {
    const auto spots = test::spots_of(test::plan_of(design, scale * size));
    CHECK(at_walls(spots, scale * size) == before);
    for (const auto& spot : spots) {
      INFO(name << " at " << scale << ": " << spot.category);
      CHECK((spot.at.array() > 0.0).all());
      CHECK((spot.at.array() < scale * size.array()).all());
    }
  }
}

TEST_CASE("Equal groups in rows and columns are one that grows with the room and by its number") {
  const Scene scene = scene_named("call-centre");
  const Json design = design_named("call-centre");
  const Json& desks = group_with(design, "desk");
  REQUIRE(desks.contains("repeat"));
  CHECK(design["parameters"]["desks"]["default"] == 8);
  const auto number_in = [&](const Vec2& size) {
    const auto spots = test::spots_of(test::plan_of(design, size));
    return std::count_if(spots.begin(), spots.end(),
                         [](const test::Spot& spot) { return spot.category == "desk"; });
  };
  const Vec2 size = size_of(scene);
  CHECK(number_in(size) == 8);
  CHECK(number_in({size.x() - 1.4, size.y()}) == 6);
  // The number says how large such a room usually is.
  const auto read = book::read_design(design, "test");
  REQUIRE(read);
  CHECK(book::usual_size(*read, {{"desks", 12.0}}).x() == Approx(size.x() + 2 * 1.45));
}

TEST_CASE("The mirror image of a room has its repeated groups where their image is") {
  const Json design = design_named("call-centre");
  const Vec2 size = size_of(scene_named("call-centre"));
  const auto spots = test::spots_of(test::plan_of(design, size)),
             images = test::spots_of(test::plan_of(design, size, true));
  for (const auto& spot : spots) {
    if (spot.category != "desk") continue;
    INFO("desk at " << spot.at.x() << ", " << spot.at.y());
    CHECK(std::any_of(images.begin(), images.end(), [&](const test::Spot& one) {
      return one.category == "desk" &&
             (one.at - Vec2(size.x() - spot.at.x(), spot.at.y())).norm() < 0.05;
    }));
  }
}

TEST_CASE("The palette's words are its roles, and what serves a thing is with it") {
  const Json living = design_named("living-room");
  CHECK(living.dump().find("{wood}") != std::string::npos);
  const Json& sofa = group_with(living, "sofa");
  std::set<std::string> with_it;
  for (const auto& thing : sofa["things"]) with_it.insert(thing["name"]);
  for (const char* thing : {"coffee table", "armchair", "rug", "chandelier"})
    CHECK(with_it.count(thing) == 1);
  // Found without groups of the room's own.
  const Json bedroom = design_named("twin-bedroom");
  const Json& desk = group_with(bedroom, "desk");
  CHECK(std::any_of(desk["things"].begin(), desk["things"].end(), [](const Json& thing) {
    return thing["name"] == "office chair" && thing.value("where", "") == "in front of desk";
  }));
}

TEST_CASE("Dwellings and empty rooms are no designs") {
  Scene scene = scene_named("living-room");
  Scene empty = scene;
  empty.objects.clear();
  CHECK_FALSE(learn_design(empty));
  scene.rooms = {scene.room, scene.room};
  const auto refused = learn_design(scene);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message.find("dwelling") != std::string::npos);
}
