// For each, nothing but and not there: verdicts against counts of their own on random scenes.
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "base/random.h"
#include "catch.h"
#include "evaluate/clauses.h"
#include "evaluate/ledger.h"
#include "roomgen/base/json.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

std::vector<std::string> numbered(const std::string& category, int count) {
  std::vector<std::string> ids;
  for (int i = 0; i < count; ++i) ids.push_back(category + "-" + std::to_string(i));
  return ids;
}

// Desks in a row, and lamps each of which stands on one of them or on the floor by the wall.
struct Office {
  Scene scene = rooms::scene(rooms::box(20, 5), {});
  std::map<std::string, int> lamps_on;
};

Office office(int desks, int lamps, Random& random) {
  Office office;
  for (int i = 0; i < desks; ++i)
    office.scene.objects.push_back(
        rooms::thing("desk-" + std::to_string(i), "desk", {1.2, 0.6, 0.75}, {1.0 + 2.0 * i, 2.5}));
  for (int i = 0; i < lamps; ++i) {
    const int desk = random.integer(0, desks);
    Object lamp = rooms::thing("table lamp-" + std::to_string(i), "table lamp", {0.2, 0.2, 0.4},
                               {desk < desks ? 1.0 + 2.0 * desk : 1.0 + i, desk < desks ? 2.5 : 4.8});
    if (desk < desks) {
      lamp.on = "desk-" + std::to_string(desk);
      lamp.mount = Mount::surface;
      lamp.position.z() = 0.75;
      ++office.lamps_on[lamp.on];
    }
    office.scene.objects.push_back(lamp);
  }
  return office;
}

RequirementVerdict verdict(const Requirement& requirement, const Scene& scene) {
  const AttributeJudge none = [](const Object&, const std::string&) { return AttributeVerdict(); };
  return check_requirements(std::vector{requirement}, scene, KindTable::built_in(), none)[0];
}

}  // namespace

TEST_CASE("A lamp on each desk is met where every desk has so many of its own") {
  Random random(17);
  int met = 0, rounds = 200;
  for (int round = 0; round < rounds; ++round) {
    const int desks = random.integer(1, 4), each = random.integer(1, 2), lamps = random.integer(0, 9);
    const Office built = office(desks, lamps, random);
    Requirement asked;
    asked.kind = Requirement::Kind::each;
    asked.category = "table lamp";
    asked.subjects = numbered("table lamp", lamps);
    asked.targets = numbered("desk", desks);
    asked.relation = RelationKind::on;
    asked.count = each;
    bool every = true;
    for (const auto& desk : asked.targets) {
      const auto found = built.lamps_on.find(desk);
      every = every && found != built.lamps_on.end() && found->second >= each;
    }
    INFO(to_json(asked).dump());
    CHECK(verdict(asked, built.scene).met() == every);
    met += every;
  }
  CHECK(met > 10);
  CHECK(met < rounds - 10);
}

TEST_CASE("One thing is one owner's at most, whoever could have it") {
  Random random(3);
  for (int round = 0; round < 300; ++round) {
    const int owners = random.integer(1, 4), things = random.integer(0, 5);
    std::set<std::pair<int, int>> could;
    for (int t = 0; t < things; ++t)
      for (int o = 0; o < owners; ++o)
        if (random.chance(0.4)) could.insert({t, o});
    // Every order of giving things to the owners in turn.
    std::vector<int> order(static_cast<std::size_t>(std::max(things, owners)));
    std::iota(order.begin(), order.end(), 0);
    bool possible = false;
    do {
      bool all = true;
      for (int o = 0; o < owners; ++o) all = all && could.count({order[static_cast<std::size_t>(o)], o}) > 0;
      possible = possible || all;
    } while (!possible && std::next_permutation(order.begin(), order.end()));
    std::vector<Object> objects;
    for (int t = 0; t < things; ++t) objects.push_back(rooms::thing(std::to_string(t), "lamp", {1, 1, 1}));
    std::vector<const Object*> there;
    for (const auto& object : objects) there.push_back(&object);
    const auto names = numbered("desk", owners);
    const auto fault = each_fault(there, names, 1, [&](const Object& object, const std::string& owner) {
      return could.count({std::stoi(object.id), std::stoi(owner.substr(5))}) > 0;
    });
    CHECK(fault.empty() == possible);
  }
}

TEST_CASE("A plant in each corner is in all four") {
  Scene scene = rooms::scene(rooms::box(4, 5), {});
  const Vec2 corners[] = {{0.2, 0.2}, {3.8, 0.2}, {3.8, 4.8}, {0.2, 4.8}};
  for (int i = 0; i < 4; ++i)
    scene.objects.push_back(rooms::thing("plant-" + std::to_string(i), "plant", {0.4, 0.4, 1.0}, corners[i], i < 2 ? 180.0 : 0.0));
  Requirement asked;
  asked.kind = Requirement::Kind::each;
  asked.category = "plant";
  asked.subjects = numbered("plant", 4);
  asked.targets = {"corner"};
  asked.relation = RelationKind::corner;
  CHECK(verdict(asked, scene).reason == "");
  scene.objects[3].position.head<2>() = Vec2(3.4, 4.8);  // two in one
  CHECK_FALSE(verdict(asked, scene).met());
}

TEST_CASE("Nothing but what is named is met where nothing else is there") {
  Random random(5);
  for (int round = 0; round < 100; ++round) {
    const int lamps = random.integer(1, 5);
    const Office built = office(2, lamps, random);
    Requirement asked;
    asked.kind = Requirement::Kind::only;
    const int allowed = random.integer(0, lamps);
    asked.subjects = numbered("table lamp", allowed);
    // Of a kind, in the whole room.
    asked.category = "lamp";
    CHECK(verdict(asked, built.scene).met() == (allowed == lamps));
    // Of any kind, in the whole room: there are desks.
    asked.category = "";
    CHECK_FALSE(verdict(asked, built.scene).met());
    // Of any kind, on one desk.
    asked.targets = {"desk-0"};
    const bool other = std::any_of(built.scene.objects.begin(), built.scene.objects.end(), [&](const Object& object) {
      return object.on == "desk-0" &&
             std::find(asked.subjects.begin(), asked.subjects.end(), object.id) == asked.subjects.end();
    });
    CHECK(verdict(asked, built.scene).met() == !other);
  }
}

TEST_CASE("What is denied is met where the same told is not") {
  Random random(8);
  for (int round = 0; round < 100; ++round) {
    const Office built = office(2, 1, random);
    Requirement asked;
    asked.kind = Requirement::Kind::relation;
    asked.category = "table lamp";
    asked.subjects = {"table lamp-0"};
    asked.targets = {"desk-" + std::to_string(random.integer(0, 1))};
    asked.relation = random.pick(std::vector{RelationKind::on, RelationKind::near, RelationKind::far});
    Requirement denied = asked;
    denied.denied = true;
    CHECK(verdict(asked, built.scene).met() != verdict(denied, built.scene).met());
    CHECK(to_json(denied).at("denied") == true);
  }
}
