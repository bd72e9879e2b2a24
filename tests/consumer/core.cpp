// The solver alone, as an engine embeds it.
#include <roomgen/solve/solve.h>

#include <cstdio>

int main() {
  using namespace roomgen;
  Problem problem;
  problem.room.polygon = *make_polygon({{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  PlacementTask bed;
  bed.object.id = bed.object.category = "bed";
  bed.object.size = {1.6, 2.05, 0.9};
  bed.object.relations = *parse_relations("edge");
  problem.tasks.push_back(bed);
  const auto solution = solve(problem, ModelTable(), KindTable::built_in());
  if (!solution || solution->held != 1) return 1;
  std::printf("bed at %.2f, %.2f\n", solution->scene.objects[0].position.x(),
              solution->scene.objects[0].position.y());
}
