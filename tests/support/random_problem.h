#pragma once

#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/problem.h"
#include "support/rooms.h"
#include "support/shapes.h"

namespace rooms {

/// A room with slanted walls, often not convex, with one or two doors and perhaps a window.
inline Room random_room(Random& random) {
  Room room;
  room.type = "test";
  do {
    if (random.chance(0.25)) {
      room.polygon = box(random.uniform(2.0, 6.0), random.uniform(2.0, 6.0)).polygon;
    } else {
      room.polygon = shapes::random_star(random, {0, 0}, 1.8, 4.0, random.integer(4, 8));
    }
  } while (!make_polygon(room.polygon.points));
  const int wanted = random.integer(1, 3);
  for (int i = 0; i < wanted; ++i) {
    const auto wall = static_cast<std::size_t>(random.integer(0, static_cast<int>(room.polygon.size()) - 1));
    const double length = room.polygon.edge(wall).length(), width = random.uniform(0.7, 1.2);
    if (length < width + 0.2) continue;
    const double from = random.uniform(0.05, length - width - 0.05);
    Opening opening = i == 1 ? window("window-0", wall, from, from + width)
                             : door(i == 0 ? "door-0" : "door-1", wall, from, from + width);
    opening.hinge_at_from = random.chance(0.5);
    if (random.chance(0.2)) opening.swing = DoorSwing::out;
    // Apart, so that the rooms are otherwise those without them.
    Random style = random.fork("style");
    if (opening.is_entrance() && style.chance(0.3)) opening.leaves = 2;
    if (opening.is_entrance() && style.chance(0.15)) opening.swing = DoorSwing::sliding;
    if (opening.is_entrance() && style.chance(0.15)) opening.type = OpeningType::passage;
    room.openings.push_back(opening);
    if (!check(room)) room.openings.pop_back();
  }
  return room;
}

/// Things of known and unknown kinds with constraints that need not make sense together.
inline std::vector<PlacementTask> random_tasks(Random& random, const Room& room, int count) {
  const std::vector<std::string> kinds = {"bed", "desk", "chair", "sofa", "coffee table", "wardrobe",
                                          "plant", "floor lamp", "rug", "dining table", "thingamajig"};
  const std::vector<RelationKind> plain = {RelationKind::edge, RelationKind::middle,
                                           RelationKind::corner};
  std::vector<PlacementTask> tasks;
  for (int i = 0; i < count; ++i) {
    PlacementTask task;
    const auto& kind = random.pick(kinds);
    const Kind& category = KindTable::built_in().get(kind);
    const double scale = random.uniform(0.6, 1.2);
    task.object = thing(kind + "-" + std::to_string(i), kind, scale * category.size);
    task.object.size = (1000.0 * task.object.size).array().round() / 1000.0;
    task.object.traits = category.traits;
    if (random.chance(0.15)) task.object.traits.round = true;
    if (random.chance(0.7)) task.object.relations.push_back({random.pick(plain), ""});
    for (int n = random.integer(0, 2); n > 0; --n) {
      const auto relation = static_cast<RelationKind>(random.integer(3, 15));
      std::string target = "wall-" + std::to_string(random.integer(0, static_cast<int>(room.polygon.size()) - 1));
      if (!room.openings.empty() && random.chance(0.3)) target = random.pick(room.openings).id;
      if (i > 0 && random.chance(0.7)) target = tasks[static_cast<std::size_t>(random.integer(0, i - 1))].object.id;
      task.object.relations.push_back({relation, target});
    }
    if (random.chance(0.4)) task.location = shapes::random_point(random, -3, 3);
    tasks.push_back(task);
  }
  return tasks;
}

inline Problem random_problem(std::uint64_t seed, int most_objects = 10) {
  Random random(seed);
  Problem problem;
  problem.name = "random";
  problem.room = random_room(random);
  problem.tasks = random_tasks(random, problem.room, random.integer(1, most_objects));
  return problem;
}

}  // namespace rooms
