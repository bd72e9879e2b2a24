#include "catch.h"
#include "roomgen/evaluate/report.h"
#include "solve/improve.h"
#include "solve/place.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

const ModelTable no_models;

Room square() {
  Room room;
  room.polygon.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  return room;
}

PlacementTask on_table(const std::string& id, const Vec3& size) {
  PlacementTask task;
  task.object = rooms::thing(id, "vase", size, {2, 2});
  task.object.mount = Mount::surface;
  task.object.on = "table-0";
  task.object.relations = {{RelationKind::on, "table-0"}};
  task.asked = true;
  task.wishes = 1;
  return task;
}

// A table of 0.5 m with a thing of 0.2 m in its middle: beside that nothing of 0.2 m fits.
struct Table {
  Table() {
    layout.add(rooms::thing("table-0", "table", {0.5, 0.5, 0.5}, {2, 2}));
    add(on_table("vase-0", {0.2, 0.2, 0.2}));
  }
  void add(const PlacementTask& task) {
    Object object = task.object;
    object.position.z() = 0.5;
    layout.add(object);
    tasks.push_back(task);
  }
  bool make_room(const PlacementTask& newcomer) {
    return roomgen::make_room(layout, newcomer, tasks, {}, random);
  }

  const Room room = square();
  Layout layout{room, KindTable::built_in(), no_models};
  std::vector<PlacementTask> tasks;
  Random random{1};
};

Scene scene_of(const Table& table) {
  Scene scene;
  scene.room = table.room;
  scene.objects.assign(table.layout.objects().begin(), table.layout.objects().end());
  return scene;
}

}  // namespace

TEST_CASE("What stands in the middle moves aside for one more") {
  Table table;
  const auto newcomer = on_table("vase-1", {0.2, 0.2, 0.2});
  REQUIRE_FALSE(place(table.layout, newcomer, {}, {}, table.random));
  REQUIRE(table.make_room(newcomer));
  REQUIRE(table.layout.find("vase-1"));
  CHECK(table.layout.find("vase-0")->position.head<2>() != Vec2(2, 2));
  CHECK(examine(scene_of(table), no_models, KindTable::built_in()).violations.empty());
}

TEST_CASE("Without any way nothing moves") {
  Table table;
  CHECK_FALSE(table.make_room(on_table("vase-1", {0.45, 0.45, 0.2})));
  CHECK_FALSE(table.layout.find("vase-1"));
  CHECK(table.layout.find("vase-0")->position.head<2>() == Vec2(2, 2));
}

TEST_CASE("What is locked stays") {
  Table table;
  Object locked = *table.layout.find("vase-0");
  locked.locked = true;
  table.layout.remove("vase-0");
  table.layout.add(locked);
  CHECK_FALSE(table.make_room(on_table("vase-1", {0.2, 0.2, 0.2})));
  CHECK(table.layout.find("vase-0")->position == locked.position);
}

TEST_CASE("Wishes are kept where they can be, habits give way") {
  Table table;
  auto newcomer = on_table("vase-1", {0.2, 0.2, 0.2});
  newcomer.object.relations.push_back({RelationKind::next_to, "vase-0"});
  newcomer.wishes = 2;
  // Nothing is on the side where there is no table.
  newcomer.object.relations.push_back({RelationKind::far, "vase-0"});
  REQUIRE(table.make_room(newcomer));
  const Object& placed = *table.layout.find("vase-1");
  CHECK(placed.relations.size() == 3);
  CHECK(gap(footprint(placed), footprint(*table.layout.find("vase-0"))) <= 0.5);
}

TEST_CASE("Crowded tables stay valid, and what stands on things moves with them") {
  Random random(7);
  int made = 0;
  for (int i = 0; i < 30; ++i) {
    Table table;
    auto book = on_table("book-0", {0.1, 0.1, 0.02});
    book.object.on = "vase-0";
    book.object.relations = {{RelationKind::on, "vase-0"}};
    book.object.position = {2, 2, 0.7};
    table.layout.add(book.object);
    table.tasks.push_back(book);
    for (int k = 1; k <= 6; ++k) {
      const auto newcomer =
          on_table("vase-" + std::to_string(k),
                   {random.uniform(0.06, 0.2), random.uniform(0.06, 0.2), 0.2});
      if (!table.make_room(newcomer)) continue;
      table.tasks.push_back(newcomer);
      ++made;
    }
    CHECK(examine(scene_of(table), no_models, KindTable::built_in()).violations.empty());
    CHECK(table.layout.find("book-0")->on == "vase-0");
    CHECK(bottom(*table.layout.find("book-0")) == Approx(top(*table.layout.find("vase-0"))).margin(0.003));
  }
  CHECK(made > 60);
}
