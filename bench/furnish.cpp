// Times planning and placing: whole rooms by rules, with every mesh loaded beforehand.

#include <algorithm>
#include <ctime>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "roomgen/design/designer.h"
#include "roomgen/generate/generate.h"
#include "roomgen/library/library.h"
#include "warm_library.h"

namespace {

using namespace roomgen;

double milliseconds_since(std::clock_t start) {
  return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

std::string text_of(const std::string& path) {
  std::ifstream stream(path);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void measure(const char* name, const std::string& prompt, std::uint64_t seed, const bench::WarmLibrary& library) {
  constexpr int runs = 7;
  std::vector<double> planning, placing;
  std::size_t objects = 0;
  int held = 0, constraints = 0;
  for (int run = 0; run <= runs; ++run) {
    auto designer = make_rule_designer();
    PlanRequest request;
    request.prompt = prompt;
    request.seed = seed;
    const auto start = std::clock();
    const auto plan = designer->plan(request);
    if (!plan) return;
    const double planned = milliseconds_since(start);
    const auto middle = std::clock();
    BuildOptions options;
    options.seed = seed;
    const auto room = generate(*plan, *designer, library, KindTable::built_in(), options);
    if (!room) return;
    if (run == 0) continue;  // loads the meshes
    planning.push_back(planned);
    placing.push_back(milliseconds_since(middle));
    objects = room->scene.objects.size();
    held = room->held, constraints = room->constraints;
  }
  std::printf("| %s | %zu | %d of %d | %.0f | %.0f |\n", name, objects, held, constraints,
              median(planning), median(placing));
}

}  // namespace

int main() {
  const auto library = bench::installed_library();
  if (!library) return 0;
  const bench::WarmLibrary warm(*library);
  std::puts("| room | objects | constraints held | planning, ms | placing, ms |");
  std::puts("|---|---|---|---|---|");
  for (const char* kind : {"living room", "bedroom", "kitchen", "bathroom", "dining room", "office"})
    measure(kind, std::string("a ") + kind, 2, warm);
  measure("44 things", text_of(ROOMGEN_BENCH_DATA "/rooms/full-living-room.txt"), 2, warm);
}
