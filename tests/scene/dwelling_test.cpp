#include <nlohmann/json.hpp>

#include "roomgen/scene/plan.h"
#include "scene/dwelling.h"

#include "catch.h"
#include "roomgen/base/json.h"
#include "roomgen/evaluate/report.h"
#include "roomgen/scene/scene.h"
#include "support/error_of.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

Room at(const std::string& id, const Vec2& low, const Vec2& high) {
  Room room = rooms::box(1, 1);
  room.id = id;
  room.polygon.points = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  return room;
}

// A hall below two rooms, all with doors.
std::vector<Room> dwelling() {
  std::vector<Room> list = {at("hall-0", {0, 0}, {7.1, 1.4}), at("bedroom-0", {0, 1.5}, {4, 5}),
                            at("bathroom-0", {4.1, 1.5}, {7.1, 5})};
  Opening entrance = rooms::door("door-0", 3, 0.2, 1.1);
  list[0].openings.push_back(entrance);
  // Wall 2 of the hall runs from right to left, wall 0 of a room from left to right.
  const auto join = [&](std::size_t room, double from, double to, const std::string& id) {
    Opening own = rooms::door("door-0", 0, from, to);
    own.leads_to = "hall-0";
    const double left = list[room].polygon.points[0].x();
    Opening seen = rooms::door(id, 2, 7.1 - (left + to), 7.1 - (left + from));
    seen.swing = DoorSwing::out;
    seen.leads_to = list[room].id;
    list[room].openings.push_back(own);
    list[0].openings.push_back(seen);
  };
  join(1, 0.2, 1.1, "door-1");
  join(2, 0.2, 1.0, "door-2");
  return list;
}

Scene furnished() {
  Scene scene;
  scene.rooms = dwelling();
  scene.objects.push_back(rooms::thing("bed-0", "bed", {1.6, 2.05, 0.9}, {2, 3.9}));
  scene.objects.back().room = "bedroom-0";
  scene.objects.push_back(rooms::thing("toilet-0", "toilet", {0.4, 0.7, 0.8}, {6, 4.6}));
  scene.objects.back().room = "bathroom-0";
  return scene;
}

std::string refusal(const std::vector<Room>& list) {
  return error_of(check_dwelling(list));
}

}  // namespace

TEST_CASE("A dwelling is written and read as it is") {
  const Scene scene = furnished();
  REQUIRE(check(scene));
  const Json json = to_json(scene);
  CHECK_FALSE(json.contains("room"));
  const auto read = scene_from_json(json, "scene.json");
  REQUIRE(read);
  CHECK(to_json(*read) == json);
  CHECK(read->rooms.size() == 3);
  CHECK(read->objects[1].room == "bathroom-0");
}

TEST_CASE("Scenes with a room and rooms, or objects in no room, are refused") {
  Json both = to_json(furnished());
  both["room"] = both["rooms"][0];
  CHECK_FALSE(scene_from_json(both, "scene.json"));
  Json nowhere = to_json(furnished());
  nowhere["objects"][0]["room"] = "cellar-0";
  const auto read = scene_from_json(nowhere, "scene.json");
  REQUIRE_FALSE(read);
  CHECK(read.error().message.find("cellar-0") != std::string::npos);
  Json many = to_json(furnished());
  while (many["rooms"].size() <= max_rooms) many["rooms"].push_back(many["rooms"][0]);
  CHECK_FALSE(scene_from_json(many, "scene.json"));
}

TEST_CASE("Parts of a dwelling are rooms with what stands in them") {
  const auto parts = parts_of(furnished());
  REQUIRE(parts.size() == 3);
  CHECK(parts[0].objects.empty());
  REQUIRE(parts[1].objects.size() == 1);
  CHECK(parts[1].room.id == "bedroom-0");
  for (const auto& part : parts) CHECK(part.rooms.empty());
  Scene single;
  single.room = rooms::box(4, 3);
  CHECK(parts_of(single).size() == 1);
  CHECK(rooms_of(single).size() == 1);
}

TEST_CASE("What makes no dwelling is told") {
  auto close = dwelling();
  for (auto& p : close[2].polygon.points) p.x() -= 0.05;
  CHECK(refusal(close).find("0.05 m apart") != std::string::npos);
  auto inside = dwelling();
  inside.push_back(at("closet-0", {1, 2}, {2, 3}));
  CHECK(refusal(inside).find("apart") != std::string::npos);
  auto twice = dwelling();
  twice[2].id = "bedroom-0";
  CHECK(refusal(twice).find("two rooms") != std::string::npos);
  auto nowhere = dwelling();
  nowhere[0].openings[0].leads_to = "cellar-0";
  CHECK(refusal(nowhere).find("no room of the dwelling") != std::string::npos);
  auto one_sided = dwelling();
  one_sided[0].openings.pop_back();
  CHECK(refusal(one_sided).find("leads back") != std::string::npos);
  auto shifted = dwelling();
  shifted[0].openings[1].from -= 0.3;
  shifted[0].openings[1].to -= 0.3;
  CHECK(refusal(shifted).find("leads back") != std::string::npos);
}

TEST_CASE("Shared stretches are seen alike from both rooms") {
  const auto list = dwelling();
  double from_hall = 0.0, from_rooms = 0.0;
  for (const auto& s : shared_stretches(list, 0)) {
    CHECK(s.wall == 2);
    from_hall += s.to - s.from;
  }
  for (std::size_t i : {1, 2})
    for (const auto& s : shared_stretches(list, i))
      if (s.room == 0) from_rooms += s.to - s.from;
  CHECK(from_hall == Approx(4.0 + 3.0));
  CHECK(from_rooms == Approx(from_hall));
  // Side by side, the bedroom and the bathroom share the depth of both.
  for (const auto& s : shared_stretches(list, 1))
    if (s.room == 2) CHECK(s.to - s.from == Approx(3.5));
}

TEST_CASE("Rooms that nobody can enter are found") {
  CHECK(rooms_without_access(dwelling()).empty());
  auto closed = dwelling();
  closed[0].openings.pop_back();
  closed[2].openings.clear();
  CHECK(rooms_without_access(closed) == std::vector<std::string>{"bathroom-0"});
  auto locked = dwelling();
  locked[0].openings.erase(locked[0].openings.begin());
  CHECK(rooms_without_access(locked).size() == 3);
}

TEST_CASE("A dwelling is examined room by room") {
  Scene scene = furnished();
  CHECK(examine(scene, {}, KindTable::built_in()).violations.empty());
  // Into the wall to the bathroom: outside of its own room, though within the dwelling.
  scene.objects[0].position.x() = 4.0;
  const auto report = examine(scene, {}, KindTable::built_in());
  REQUIRE(report.violations.size() >= 1);
  CHECK(report.violations[0].fault == Fault::outside);
  scene = furnished();
  scene.rooms[0].openings.erase(scene.rooms[0].openings.begin());
  bool no_access = false;
  for (const auto& v : examine(scene, {}, KindTable::built_in()).violations)
    no_access = no_access || v.fault == Fault::no_access;
  CHECK(no_access);
}

TEST_CASE("Objects are numbered through the rooms of a plan, wherever they are named") {
  DwellingPlan plan;
  for (int i = 0; i < 2; ++i) {
    Plan room;
    PlanItem bed, stand;
    bed.category = "bed";
    stand.category = "nightstand";
    stand.quantity = 2;
    stand.relations = {{RelationKind::near, "bed-0"}, {RelationKind::near, "wall-0"}};
    room.items = {bed, stand};
    Requirement near;
    near.subjects = {"nightstand-0", "nightstand-1"};
    near.targets = {"bed-0"};
    room.requirements = {near};
    plan.rooms.push_back(room);
  }
  auto list = dwelling();
  for (std::size_t i = 0; i < 2; ++i) plan.rooms[i].room = list[i];
  number_through(plan);
  CHECK(planned_objects(plan.rooms[0])[0].id == "bed-0");
  const auto second = planned_objects(plan.rooms[1]);
  CHECK(second[0].id == "bed-1");
  CHECK(second[2].id == "nightstand-3");
  CHECK(plan.rooms[1].items[1].relations[0].target == "bed-1");
  CHECK(plan.rooms[1].items[1].relations[1].target == "wall-0");
  CHECK(plan.rooms[1].requirements[0].subjects ==
        std::vector<std::string>{"nightstand-2", "nightstand-3"});
  CHECK(plan.rooms[1].requirements[0].targets == std::vector<std::string>{"bed-1"});
}

TEST_CASE("The plan of a dwelling is written and read as it is") {
  DwellingPlan plan;
  plan.prompt = "a test";
  plan.seed = 7;
  for (const auto& room : dwelling()) {
    Plan each;
    each.room = room;
    PlanItem lamp;
    lamp.category = "floor lamp";
    each.items = {lamp};
    plan.rooms.push_back(each);
  }
  number_through(plan);
  const Json json = to_json(plan);
  CHECK(is_dwelling_plan(json));
  const auto read = dwelling_plan_from_json(json, "plan.json");
  REQUIRE(read);
  CHECK(to_json(*read) == json);
  CHECK(planned_objects(read->rooms[2])[0].id == "floor lamp-2");
  CHECK_FALSE(plan_from_json(json, "plan.json"));
  CHECK_FALSE(is_dwelling_plan(to_json(plan.rooms[0])));
}
