// The choice must not depend on how fine the grid is: one next object in a fixed room, a suggestion, and
// three pitches.
#include "solve/place.h"
#include "support/rooms.h"
#include "support/shapes.h"
#include "support/solved.h"

using namespace roomgen;

namespace {

//  +------window-0----+---+
//  |      |  bed-0    |   |
//  |desk-0|           |   |
//  |      +-----------+   |
//  |                   wardrobe-0
//  +-door-0---------------+
struct Furnished {
  Room room = rooms::box(5, 4);
  std::vector<Object> objects = {
      rooms::thing("bed-0", "bed", {1.6, 2.05, 0.9}, {3.2, 2.97}, 0),
      rooms::thing("desk-0", "desk", {1.2, 0.6, 0.75}, {0.31, 2.4}, 90),
      rooms::thing("wardrobe-0", "wardrobe", {1.2, 0.6, 2.0}, {4.69, 0.7}, -90)};

  Furnished() {
    room.openings = {rooms::door("door-0", 0, 0.5, 1.4), rooms::window("window-0", 2, 1.5, 3.0)};
  }

  std::optional<Vec2> place_at(const PlacementTask& task, double pitch) const {
    const ModelTable models;
    Layout layout(room, KindTable::built_in(), models);
    for (const auto& object : objects) layout.add(object);
    PlaceOptions options;
    options.pitch = pitch;
    Random random(1);
    const auto placement = place(layout, task, {}, options, random);
    if (!placement) return std::nullopt;
    return Vec2(placement->object.position.head<2>());
  }
};

struct Wish {
  const char* category;
  const char* relations;
};
const std::vector<Wish> wishes = {
    {"armchair", "face to, bed-0 | near, window-0"},
    {"plant", "near, window-0"},
    {"plant", "edge"},
    {"office chair", "in front of, desk-0 | face to, desk-0 | near, desk-0"},
    {"bookshelf", "edge | far, bed-0"},
    {"bench", "middle | in front of, bed-0"},
    {"nightstand", "edge | side of, bed-0 | near, bed-0"},
    {"floor lamp", "near, desk-0"},
    {"rug", "middle"},
    {"coffee table", "middle | near, bed-0 | aligned, bed-0"},
    {"dresser", "edge | face to, bed-0"},
    {"plant", "corner"},
    {"side table", ""},
    {"armchair", "edge | far, door-0"}};

PlacementTask task_of(const Wish& wish) {
  const Kind& category = KindTable::built_in().get(wish.category);
  PlacementTask task;
  task.object = rooms::thing("new-0", wish.category, category.size);
  task.object.traits = category.traits;
  task.object.relations = *parse_relations(wish.relations);
  return task;
}

// How many of 200 choices move by at most 0.2 m at both refinements.
template <typename Suggest>
int stable_cases(Suggest suggest) {
  const Furnished furnished;
  int stable = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    Random random(i);
    PlacementTask task = task_of(random.pick(wishes));
    task.location = suggest(furnished, task, random);
    const auto coarse = furnished.place_at(task, 0.20), usual = furnished.place_at(task, 0.10),
               fine = furnished.place_at(task, 0.05);
    if (coarse && usual && fine && (*coarse - *usual).norm() <= 0.2 && (*usual - *fine).norm() <= 0.2)
      ++stable;
  }
  return stable;
}

}  // namespace

TEST_CASE("Refining the grid moves the choice near a fair suggestion by at most 0.2 m in 98 of 100 cases") {
  // Suggestions off by a standard deviation of 0.5 m from a place that is good.
  const int stable = stable_cases([](const Furnished& furnished, const PlacementTask& task, Random& random) {
    const auto good = furnished.place_at(task, 0.10);
    REQUIRE(good);
    const double dx = random.normal(0.0, 0.5);
    return Vec2(*good + Vec2(dx, random.normal(0.0, 0.5)));
  });
  WARN(stable << " of 200 stable");
  CHECK(stable >= 196);
}

TEST_CASE("Refining the grid moves the choice for suggestions anywhere by at most 0.2 m in 95 of 100 cases") {
  // Where the constraints hold only far from the suggestion, places on an arc around it are equally good,
  // and the cells between depend a little on the grid.
  const int stable = stable_cases([](const Furnished&, const PlacementTask&, Random& random) {
    const double x = random.uniform(0.3, 4.7);
    return Vec2(x, random.uniform(0.3, 3.7));
  });
  WARN(stable << " of 200 stable");
  CHECK(stable >= 190);
}
