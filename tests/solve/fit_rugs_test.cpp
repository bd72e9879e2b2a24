// Rugs are cut so that all stands on them with all feet or none. Random rooms full of tables on legs and
// of chests; that nothing meets a rug is asked of the meshes.
#include "solve/fit_rugs.h"

#include "base/random.h"
#include "catch.h"
#include "collision/solids.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

constexpr double leg = 0.06;

ModelTable with_table() {
  auto model = std::make_shared<Model>();
  model->materials.resize(1);
  ModelPart part;
  append(part.mesh, make_box({-0.5, -0.5, 0.7}, {0.5, 0.5, 0.75}));
  for (const double x : {-0.5, 0.5 - leg})
    for (const double y : {-0.5, 0.5 - leg})
      append(part.mesh, make_box({x, y, 0}, {x + leg, y + leg, 0.7}));
  model->parts.push_back(part);
  ModelTable models;
  models.add("test/table", model);
  return models;
}

Object table(const std::string& id, const Vec2& at, double yaw = 0.0) {
  Object o = rooms::thing(id, "table", {1, 1, 0.75}, at, yaw);
  o.asset = {"test", "table", "", "", "", std::nullopt};
  return o;
}

Object rug(const Vec2& size, const Vec2& at, double yaw = 0.0, bool round = false) {
  Object o = rooms::thing("rug-0", "rug", {size.x(), size.y(), 0.02}, at, yaw);
  o.traits.flat = true;
  o.traits.round = round;
  return o;
}

const Object& named(const std::vector<Object>& objects, const std::string& id) {
  return *std::find_if(objects.begin(), objects.end(), [&](const Object& o) { return o.id == id; });
}

RugFit fit(const Room& room, std::vector<Object>& objects, std::vector<RugWish> wishes = {}) {
  static const ModelTable models = with_table();
  return fit_rugs(room, objects, models, KindTable::built_in(), wishes);
}

// Tables and chests that keep apart, each with a vase, under them a rug at any place.
std::vector<Object> random_things(const Room& room, Random& random) {
  const Vec2 most = bounds(room.polygon).high;
  const auto somewhere = [&] { return Vec2(random.uniform(0.8, most.x() - 0.8), random.uniform(0.8, most.y() - 0.8)); };
  std::vector<Object> things;
  for (int k = 0; k < 7; ++k) {
    const std::string number = std::to_string(k);
    const double yaw = random.chance(0.7) ? 90.0 * random.integer(0, 3) : random.uniform(-180, 180);
    const Object one = random.chance(0.5) ? table("table-" + number, somewhere(), yaw)
                                          : rooms::thing("chest-" + number, "chest", {0.9, 0.4, 0.5}, somewhere(), yaw);
    const bool apart = std::none_of(things.begin(), things.end(), [&](const Object& other) {
      return overlaps(footprint(one), footprint(other), -0.05);
    });
    if (!apart || !contains(room.polygon, footprint(one))) continue;
    Object vase = rooms::thing("vase-" + number, "vase", {0.1, 0.1, 0.2}, one.position.head<2>());
    vase.mount = Mount::surface;
    vase.on = one.id;
    vase.position.z() = one.size.z();
    things.push_back(one);
    things.push_back(vase);
  }
  const bool round = random.chance(0.3);
  const double width = random.uniform(1.2, 2.4);
  Object under = rug({width, round ? width : random.uniform(0.8, 2.4)}, somewhere(), 90.0 * random.integer(0, 1), round);
  if (contains(room.polygon, footprint(under))) things.push_back(under);
  return things;
}

}  // namespace

TEST_CASE("Nothing stands on a rug with some of its feet") {
  const ModelTable models = with_table();
  Solids solids(models);
  int rugs = 0, kept = 0, lifted = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    Random random(seed);
    const Room room = rooms::box(random.uniform(3.0, 6.0), random.uniform(3.0, 6.0));
    const auto before = random_things(room, random);
    auto objects = before;
    INFO("seed " << seed);
    const RugFit done = fit(room, objects);
    CHECK(done.uneven.empty());
    CHECK(objects.size() + done.left_out.size() == before.size());
    rugs += before.empty() || !before.back().traits.flat ? 0 : 1;
    if (objects.empty() || !objects.back().traits.flat) continue;
    ++kept;
    const Object& lying = objects.back();
    CHECK(contains(room.polygon, footprint(lying)));
    for (const auto& object : objects) {
      if (object.id == lying.id) continue;
      INFO(object.id);
      CHECK_FALSE(solids.intersect(object, lying));
      const double rise = object.position.z() - named(before, object.id).position.z();
      if (rise != 0.0) CHECK(rise == Approx(0.02));
      if (!object.on.empty()) {
        CHECK(bottom(object) == Approx(top(named(objects, object.on))));
        continue;
      }
      lifted += rise > 0 ? 1 : 0;
      const Footprint base = footprint(object);
      for (const auto& corner : base.outline())
        if (rise > 0) CHECK(gap(footprint(lying), corner) < 3e-3);
    }
  }
  CHECK(kept > 0.95 * rugs);
  CHECK(lifted > 50);
}

TEST_CASE("A rug under all or nothing of what stands there stays as it lies") {
  std::vector<Object> objects = {table("table-0", {3, 3}), rug({2, 2}, {3, 3})};
  fit(rooms::box(6, 6), objects);
  CHECK(objects[1].size == Vec3(2, 2, 0.02));
  CHECK(objects[0].position == Vec3(3, 3, 0.02));
  objects = {table("table-0", {3, 3}), rug({0.5, 3}, {3, 3})};  // between the legs
  fit(rooms::box(6, 6), objects);
  CHECK(objects[1].size == Vec3(0.5, 3, 0.02));
  CHECK(objects[0].position == Vec3(3, 3, 0));
}

TEST_CASE("A rug stays where it was said to lie, and where it cannot it is rather cut than moved") {
  const std::vector<Object> between = {table("table-0", {3, 3}), rug({0.7, 3}, {3, 3})};
  for (const bool told : {false, true}) {
    auto objects = between;  // its legs might come onto a larger one
    fit(rooms::box(6, 6), objects, {{"rug-0", true, false, 0, told}});
    CHECK((objects[1].size == between[1].size) == told);
  }
  std::vector<Object> objects = {rooms::thing("chest-0", "chest", {3, 0.9, 0.8}, {3, 1.8}),
                                 rooms::thing("chest-1", "chest", {3, 0.9, 0.8}, {3, 4.2}),
                                 rug({3, 1.8}, {3, 3})};
  CHECK(fit(rooms::box(6, 6), objects, {{"rug-0", true, true, 0, true}}).uneven.empty());
  CHECK((objects[2].position - Vec3(3, 3, 0)).norm() < 0.1);
  CHECK(objects[2].size.y() > 1.3);
}

TEST_CASE("The chairs of a table come onto its rug") {
  Object chair = rooms::thing("chair-0", "chair", {0.5, 0.5, 0.9}, {3, 1.9});
  chair.relations = {{RelationKind::around, "table-0"}};
  Object chest = rooms::thing("chest-0", "chest", {0.5, 0.5, 0.9}, {3, 4.4});
  std::vector<Object> objects = {table("table-0", {3, 3}), chair, chest, rug({2, 2.4}, {3, 3})};
  fit(rooms::box(6, 6), objects);
  CHECK(objects[1].position.z() == Approx(0.02));
  CHECK(objects[2].position.z() == 0.0);  // which it has nothing to do with
}

TEST_CASE("A thing that may not be lifted keeps the rug from under it") {
  const Object high = rooms::thing("chest-0", "chest", {0.5, 0.5, 2.7}, {3, 3});
  std::vector<Object> objects = {high, rug({2, 2}, {3.2, 3})};
  CHECK(fit(rooms::box(6, 6, 2.7), objects).uneven.empty());
  REQUIRE(objects.size() == 2);
  CHECK(objects[0].position.z() == 0.0);
  CHECK_FALSE(overlaps(footprint(objects[0]), footprint(objects[1])));
}

TEST_CASE("Where no rug can lie, an asked one stays with a word and another goes") {
  const Room room = rooms::box(2, 2);  // filled by two chests, each as high as it is
  const std::vector<Object> full = {rooms::thing("chest-0", "chest", {2, 1, 2.7}, {1, 0.5}),
                                    rooms::thing("chest-1", "chest", {2, 1, 2.7}, {1, 1.5}), rug({1.5, 1.5}, {1, 1})};
  auto objects = full;
  CHECK(fit(room, objects).left_out == std::vector<std::string>{"rug-0"});
  CHECK(objects.size() == 2);
  objects = full;
  CHECK(fit(room, objects, {{"rug-0", true}}).uneven == std::vector<std::string>{"rug-0"});
  CHECK(objects.size() == 3);
}

TEST_CASE("A locked rug stays, and what is wholly on it stands at its top") {
  Object locked = rug({2, 2}, {3, 3});
  locked.locked = true;
  std::vector<Object> objects = {table("table-0", {3, 3}), table("table-1", {4.2, 3}), locked};
  CHECK(fit(rooms::box(6, 6), objects).uneven == std::vector<std::string>{"rug-0"});
  CHECK(objects[2].position == locked.position);
  CHECK(objects[0].position.z() == Approx(0.02));
  CHECK(objects[1].position.z() == 0.0);
}

TEST_CASE("Small rugs lie on larger ones, and what stands there is as high as both") {
  Object small = rug({1.2, 1.2}, {3, 3});
  small.id = "rug-1";
  Object large = rug({3, 3}, {3, 3});
  std::vector<Object> objects = {small, large, table("table-0", {3, 3}), table("table-1", {3, 4.2})};
  objects[3].size = {0.5, 0.5, 0.4};
  CHECK(fit(rooms::box(6, 6), objects).uneven.empty());
  CHECK(objects[0].position == Vec3(3, 3, 0.02));
  CHECK(objects[1].position == Vec3(3, 3, 0));
  CHECK(objects[2].position.z() == Approx(0.04));
  CHECK(objects[3].position.z() == Approx(0.02));
  CHECK(may_lie_over(footprint(small), footprint(large)));
  CHECK_FALSE(may_lie_over(footprint(large), footprint(small)));
  small.position.x() += 1.4;  // more than a little beyond its edge
  CHECK(boxes_clash(small, footprint(small), 0, large, footprint(large)));
}
