// What scoring finds against what checking finds, and dwellings against their rooms.
#include "roomgen/evaluate/report.h"
#include "roomgen/lab/scores.h"

#include <nlohmann/json.hpp>
#include <set>

#include "catch.h"
#include "roomgen/base/json.h"
#include "support/furnished_room.h"
#include "support/random_mesh.h"
#include "support/rooms.h"

using namespace roomgen;
using namespace roomgen::lab;

namespace {

using Pairs = std::set<std::set<std::string>>;

Requirements asking(const std::string& columns, const std::string& fields) {
  const auto rows = parse_requirements("ID,Description,ObjCount" + columns + "\n1,x," + fields + "\n", "r");
  REQUIRE(rows);
  return rows->front();
}

Pairs overlaps_in(const SceneReport& report) {
  Pairs pairs;
  for (const auto& violation : report.violations)
    if (violation.fault == Fault::overlap) pairs.insert({violation.object, violation.other});
  return pairs;
}

// Of solids: rugs collide too for who scores.
Pairs collisions_in(const RoomScore& score, const Scene& scene) {
  Pairs pairs;
  for (const auto& [a, b] : score.collisions)
    if (!find_object(scene, a)->traits.flat && !find_object(scene, b)->traits.flat) pairs.insert({a, b});
  return pairs;
}

// A cross of two bars: it leaves the ellipse of its box in four places.
Model cross() {
  Model model;
  model.materials.emplace_back();
  model.parts = {{make_box({-0.5, -0.05, 0}, {0.5, 0.05, 1}), 0}, {make_box({-0.05, -0.5, 0}, {0.05, 0.5, 1}), 0}};
  return model;
}

Scene two_rooms() {
  Scene scene;
  for (int k = 0; k < 2; ++k) {
    Room room = rooms::box(4, 3);
    room.id = "room-" + std::to_string(k);
    room = rooms::moved(room, 0, {4.1 * k, 0});
    room.openings = {rooms::door("door-" + std::to_string(k), 0, 0.5, 1.4)};
    scene.rooms.push_back(room);
  }
  const auto add = [&](const std::string& id, const Vec2& at, int room) {
    scene.objects.push_back(rooms::thing(id, "desk", {1.2, 0.6, 0.75}, at));
    scene.objects.back().room = "room-" + std::to_string(room);
  };
  add("desk-0", {2, 2.69}, 0);
  add("desk-1", {6, 1.5}, 1);
  add("desk-2", {6.5, 1.6}, 1);  // through desk-1
  return scene;
}

}  // namespace

TEST_CASE("Scoring and checking find the same solids in collision, round or not, box or mesh") {
  const Requirements nothing = asking("", "");
  std::size_t found = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Scene scene = test::random_scene(seed);
    Random random(seed);
    ModelTable models;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      Object& object = scene.objects[i];
      object.traits.round = random.chance(0.4);
      object.traits.flat = random.chance(0.1);
      if (random.chance(0.3)) test::use_model(object, models, "cross", cross());
      if (random.chance(0.2))
        test::use_model(object, models, "soup-" + std::to_string(i),
                        {{{shapes::random_soup(random, 60, 1), 0}}, {Material()}});
    }
    const auto checked = overlaps_in(examine(scene, models, KindTable::built_in()));
    INFO("scene " << seed);
    CHECK(collisions_in(score_room(nothing, scene, models), scene) == checked);
    found += checked.size();
  }
  CHECK(found > 100);
}

TEST_CASE("What leaves its ellipse collides where it is, not where its ellipse is") {
  Scene scene = rooms::scene(rooms::box(6, 4), {rooms::thing("stool-0", "stool", {1, 1, 1}, {2, 2}, 45),
                                                rooms::thing("stool-1", "stool", {1, 1, 1}, {2.72, 2.72}, 45)});
  ModelTable models;
  for (auto& object : scene.objects) {
    Model square;
    square.materials.emplace_back();
    square.parts = {{make_box({-0.5, -0.5, 0}, {0.5, 0.5, 1}), 0}};
    test::use_model(object, models, "square", square);
    object.traits.round = true;
    object.yaw = 0.0;
  }
  REQUIRE(gap(footprint(scene.objects[0]), footprint(scene.objects[1])) > 0.0);
  CHECK(overlaps_in(examine(scene, models, KindTable::built_in())).size() == 1);
  CHECK(score_room(asking("", ""), scene, models).collisions.size() == 1);
}

TEST_CASE("Crossing meshes collide, touching and parted ones do not") {
  const auto pairs = [](double x) {
    const Scene scene = rooms::scene(rooms::box(5, 4), {rooms::thing("a-0", "thing", {1, 1, 1}),
                                                        rooms::thing("b-0", "thing", {1, 1, 0.8}, {x, 0.1})});
    return score_room(asking("", ""), scene, ModelTable()).collisions.size();
  };
  CHECK(pairs(0.9) == 1);
  CHECK(pairs(0.998) == 0);  // the 5 mm that are forgiven
  CHECK(pairs(1.1) == 0);
}

TEST_CASE("A dwelling is scored as a whole, and each of its rooms by itself") {
  const Scene scene = two_rooms();
  const auto score = score_room(asking(",OARel", "\"eq,3,desk\",\"eq,1,against,desk,wall\""), scene, ModelTable());
  CHECK(score.objects == 3);
  CHECK(score.doors == 2);
  CHECK(score.counts.front().satisfied);
  CHECK(score.room_relations.front().satisfied);  // only desk-0 is at a wall of its own room
  CHECK(score.collisions.size() == 1);
  CHECK(score.outside.empty());
  REQUIRE(score.rooms.size() == 2);
  CHECK(score.rooms[0].id == "room-0");
  CHECK(score.rooms[0].objects == 1);
  CHECK(score.rooms[0].collisions.empty());
  CHECK(score.rooms[1].collisions.size() == 1);
  CHECK(score.navigability == Approx(0.5 * (score.rooms[0].navigability + score.rooms[1].navigability)));
}

TEST_CASE("A room that a requirement names is one of that kind, if the dwelling has any") {
  Scene scene = two_rooms();
  scene.rooms[1].type = "study";
  const auto score = score_room(asking(",OARel", "\"eq,3,desk\",\"eq,2,in,desk,study;eq,1,in,desk,study_2;eq,3,in,desk,den\""),
                                scene, ModelTable());
  CHECK(score.room_relations[0].satisfied);
  CHECK_FALSE(score.room_relations[1].satisfied);
  CHECK(score.room_relations[2].satisfied);
}

TEST_CASE("A room by itself scores as it does as the only one of a dwelling") {
  Scene one = rooms::scene(rooms::box(5, 4), {rooms::thing("desk-0", "desk", {1.2, 0.6, 0.75}, {2, 2}),
                                              rooms::thing("desk-1", "desk", {1.2, 0.6, 0.75}, {2.5, 2.2})});
  const Requirements row = asking(",OARel", "\"eq,2,desk\",\"eq,1,against,desk,wall\"");
  const auto alone = score_room(row, one, ModelTable());
  one.room.id = "room-0";
  one.rooms = {one.room};
  for (auto& object : one.objects) object.room = "room-0";
  const auto within = score_room(row, one, ModelTable());
  Json a = score_json(std::vector{alone}), b = score_json(std::vector{within});
  b["scores"][0].erase("rooms");
  CHECK(a.dump() == b.dump());
}

TEST_CASE("What could not be scored is named in the reports") {
  const std::vector<Unscored> unscored = {{"7", "7/scene.json: is cut off"}};
  CHECK(score_json({}, unscored)["unscored"][0]["id"] == "7");
  CHECK(score_markdown({}, unscored).find("- 7: 7/scene.json: is cut off") != std::string::npos);
}

namespace {

// An armchair of a library and a sofa that was built, both with what was asked for in words.
Scene described_things(const std::string& wish) {
  Scene scene;
  scene.room = rooms::box(5, 4);
  scene.objects = {rooms::thing("armchair-0", "armchair", {0.8, 0.8, 1.0}, {1, 1}),
                   rooms::thing("sofa-0", "sofa", {2.0, 0.9, 0.8}, {3, 3})};
  scene.objects[0].asset.library = "Scopia";
  scene.objects[0].asset.id = "armchair";
  ProceduralSource built;
  built.recipe = "words";
  built.params = Json{{"kind", "sofa"}, {"description", wish}, {"size", {2.0, 0.9, 0.8}}}.dump();
  scene.objects[1].asset.procedural = built;
  scene.objects[1].asset.finish = {{"upholstery", "red velvet"}};
  for (auto& object : scene.objects) object.description = wish;
  return scene;
}

Model red_velvet() {
  Model model;
  Material velvet;
  velvet.name = "red velvet";
  velvet.base_color = {0.5f, 0.02f, 0.02f, 1.0f};
  velvet.roughness = 0.95f;
  model.materials = {velvet};
  model.parts = {{make_box({-0.5, -0.5, 0}, {0.5, 0.5, 1}), 0}};
  return model;
}

std::vector<std::string> verdicts_of(const Scene& scene) {
  ModelTable models;
  for (const auto& object : scene.objects)
    models.add(asset_key(object.asset), std::make_shared<Model>(red_velvet()));
  const auto row = asking(",ObjAttr", "\"eq,1,armchair;eq,1,sofa;eq,1,gilded throne;eq,1,velvet sofa\","
                                      "\"eq,1,armchair,leather;eq,1,sofa,red;eq,1,sofa,velvet;eq,1,sofa,gilded\"");
  const auto score = score_room(row, scene, models);
  std::vector<std::string> all;
  for (const auto* verdicts : {&score.counts, &score.attributes})
    for (const auto& verdict : *verdicts)
      all.push_back(verdict.text + (verdict.satisfied ? " yes " : " no ") + verdict.reason);
  return all;
}

}  // namespace

TEST_CASE("Blanking every description and wish in a scene changes no verdict") {
  const auto verdicts = verdicts_of(described_things("a gilded throne, a velvet sofa of leather"));
  CHECK(verdicts == verdicts_of(described_things("")));
  CHECK(std::count_if(verdicts.begin(), verdicts.end(),
                      [](const auto& text) { return text.find(" yes ") != std::string::npos; }) >= 3);
}

TEST_CASE("Of a crowd 200 pairs are named, all that collide are counted, and nothing is held") {
  const auto pile = [](int count) {
    std::vector<Object> objects;
    for (int i = 0; i < count; ++i) objects.push_back(rooms::thing("c-" + std::to_string(i), "thing", {0.5, 0.5, 0.5}, {2, 2}));
    return score_room(asking("", ""), rooms::scene(rooms::box(6, 6), objects), ModelTable());
  };
  const RoomScore some = pile(20), many = pile(30);
  CHECK(some.collisions.size() == 190);
  CHECK(some.colliding.size() == 20);
  CHECK(some.unsupported.empty());
  CHECK(many.collisions.size() == 200);
  CHECK(many.colliding.size() == 30);
  CHECK(many.unsupported.size() == 30);
}

TEST_CASE("Attributes count the things that have all of them") {
  Scene scene;
  scene.room = rooms::box(5, 4);
  ModelTable models;
  const auto add = [&](const std::string& id, const std::string& mesh, const Eigen::Vector3f& color) {
    Object object = rooms::thing(id, "desk", {1.2, 0.6, 0.75}, {1 + scene.objects.size() * 1.5, 2});
    test::use_model(object, models, mesh, test::colored_box(object.size, color));
    scene.objects.push_back(object);
  };
  add("desk-0", "plain_desk", {255, 0, 0});
  add("desk-1", "simple_desk", {0, 0, 255});
  const auto score = [&](const std::string& attributes) {
    const auto rows = parse_requirements("ID,Description,ObjCount,ObjAttr\n1,x,\"eq,2,desk\",\"" + attributes + "\"\n", "r");
    return score_room(rows->front(), scene, models);
  };
  CHECK(score("eq,1,desk,red").attributes.front().satisfied);
  CHECK_FALSE(score("eq,2,desk,red").attributes.front().satisfied);
  CHECK_FALSE(score("eq,1,desk,red,round").attributes.front().satisfied);
  CHECK(score("eq,1,desk,blue,rectangular").attributes.front().satisfied);
  const auto missing = score("eq,1,sofa,red").attributes.front();
  CHECK_FALSE(missing.satisfied);
  CHECK(missing.missing == "sofa");
  CHECK(score("eq,1,desk,beloved").attributes.front().unjudged == std::vector<std::string>{"beloved"});
}
