#include "synthetic.h"

#include <cmath>
#include <random>
#include <string>

namespace roomgen {

namespace {

struct SyntheticKind {
  const char* category;
  Vec3 size;
};

const SyntheticKind synthetic_kinds[] = {
    {"sideboard", {1.0, 0.42, 0.85}},
    {"table", {1.0, 0.7, 0.74}},
    {"chair", {0.46, 0.5, 0.9}},
    {"chair", {0.46, 0.5, 0.9}},
};

// The same wherever it runs, which the distributions of the standard library do not promise.
double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * std::ldexp(static_cast<double>(random() >> 11), -53);
}

PlacementTask make_task(int index, const std::string& table, std::mt19937_64& random) {
  const int kind = index % 4;
  PlacementTask task;
  Object& object = task.object;
  object.category = synthetic_kinds[kind].category;
  object.id = object.category + "-" + std::to_string(index);
  object.size = uniform(random, 0.9, 1.1) * synthetic_kinds[kind].size;
  if (kind == 0) object.relations = {{RelationKind::edge, ""}};
  if (kind == 1) object.relations = {{RelationKind::middle, ""}};
  if (kind >= 2) object.relations = {{RelationKind::around, table}};
  return task;
}

}  // namespace

Problem synthetic_problem(const SyntheticOptions& options) {
  std::mt19937_64 random(options.seed);
  const double area = options.area_per_object * options.objects;
  const double width = std::sqrt(area * 4.0 / 3.0), depth = std::sqrt(area * 3.0 / 4.0);
  Problem problem;
  problem.name = "synthetic";
  problem.room.type = "hall";
  problem.room.polygon.points = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
  Opening door;
  door.id = "door-0";
  door.from = 0.4;
  door.to = 1.3;
  problem.room.openings.push_back(door);
  std::string table;
  for (int i = 0; i < options.objects; ++i) {
    problem.tasks.push_back(make_task(i, table, random));
    if (i % 4 == 1) table = problem.tasks.back().object.id;
    if (options.suggestions) {
      const double y = uniform(random, 0, depth);
      problem.tasks.back().location = Vec2(uniform(random, 0, width), y);
    }
  }
  return problem;
}

}  // namespace roomgen
