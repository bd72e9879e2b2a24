// Times the placing of plans with groups, against the same things at the same places one by one, and one by one
// without a word of where they go.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <map>
#include <string>
#include <vector>

#include "roomgen/design/designer.h"
#include "roomgen/generate/generate.h"
#include "roomgen/library/library.h"
#include "warm_library.h"

namespace {

using namespace roomgen;

// The things of a room without its groups, what others stand on before those.
Plan one_by_one(const Plan& plan, const Scene& scene, bool is_placed) {
  Plan alone = plan;
  alone.groups.clear(), alone.items.clear();
  auto objects = scene.objects;
  std::stable_partition(objects.begin(), objects.end(),
                        [](const Object& object) { return object.on.empty(); });
  for (const auto& object : objects) {
    PlanItem item;
    item.category = object.category;
    item.description = object.description;
    item.size = object.size;
    item.mount = object.mount;
    item.asked = true;
    if (is_placed) item.location = object.position.head<2>(), item.facing = object.yaw;
    if (object.mount == Mount::wall) item.height = object.position.z() + 0.5 * object.size.z();
    alone.items.push_back(std::move(item));
  }
  std::map<std::string, std::string> ids;  // as they are numbered now
  const auto planned = planned_objects(alone);
  for (std::size_t i = 0; i < objects.size(); ++i) ids[objects[i].id] = planned[i].id;
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (!objects[i].on.empty())
      alone.items[i].relations = {{RelationKind::on, ids[objects[i].on]}};
  return alone;
}

struct Timed {
  double milliseconds = 0.0;
  Scene scene;
};

Timed timed(const Plan& plan, const AssetLibrary& library, int runs) {
  Timed result;
  std::vector<double> times;
  for (int run = 0; run <= runs; ++run) {
    const auto designer = make_rule_designer();
    BuildOptions options;
    options.seed = 1;
    options.repair = false;  // not everything has a place by the plan
    options.improvement = Improvement::off;
    const auto start = std::clock();
    auto room = generate(plan, *designer, library, KindTable::built_in(), options);
    if (!room) return result;
    if (run > 0)  // the first one loads the meshes
      times.push_back(1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    result.scene = std::move(room->scene);
  }
  std::sort(times.begin(), times.end());
  result.milliseconds = times[times.size() / 2];
  return result;
}

}  // namespace

int main() {
  const auto library = bench::installed_library();
  if (!library) return 0;
  const bench::WarmLibrary warm(*library);
  std::puts("| room | groups | things | with groups, ms | one by one, same places, ms | one by one, ms | times faster |");
  std::puts("|---|---|---|---|---|---|---|");
  double sums[3] = {};
  const auto row = [](const std::string& name, std::size_t groups, std::size_t things, const double (&ms)[3]) {
    std::printf("| %s | %zu | %zu | %.0f | %.0f | %.0f | %.2f |\n", name.c_str(), groups, things, ms[0], ms[1], ms[2],
                ms[1] / ms[0]);
  };
  std::size_t groups = 0, things = 0;
  for (const char* number : {"02", "04", "05", "09", "11", "12"}) {
    const auto plan = read_plan(std::string(ROOMGEN_BENCH_DATA "/played/room-") + number + ".json");
    if (!plan) return std::puts(plan.error().message.c_str()), 1;
    const auto grouped = timed(*plan, warm, 3);
    const double ms[3] = {grouped.milliseconds, timed(one_by_one(*plan, grouped.scene, true), warm, 3).milliseconds,
                          timed(one_by_one(*plan, grouped.scene, false), warm, 1).milliseconds};
    for (int i = 0; i < 3; ++i) sums[i] += ms[i];
    groups += plan->groups.size(), things += grouped.scene.objects.size();
    row(number, plan->groups.size(), grouped.scene.objects.size(), ms);
  }
  row("all", groups, things, sums);
}
