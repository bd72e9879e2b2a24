// What it costs that meshes are read by a process of their own: the libraries indexed, and a room made with a warm
// catalogue, in turn that way and in this process. Processor time of this process and its children, the least of the
// runs: what else the machine does only ever adds.
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

#include "roomgen/assets/catalogue.h"
#include "roomgen/create/create.h"
#include "roomgen/design/designer.h"
#include "roomgen/generate/generate.h"
#include "roomgen/library/library.h"

namespace {

using namespace roomgen;
namespace fs = std::filesystem;

constexpr int index_runs = 2, room_runs = 9;

double seconds_of(int who) {
  rusage usage{};
  getrusage(who, &usage);
  const auto seconds = [](const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double processor_seconds() {
  return seconds_of(RUSAGE_SELF) + seconds_of(RUSAGE_CHILDREN);
}

assets::CatalogueOptions options_for(bool trusted, const fs::path& cache, bool rebuild) {
  assets::CatalogueOptions options;
  options.trusted = trusted;
  options.cache_dir = cache;
  options.rebuild = rebuild;
  return options;
}

bool index(bool trusted, const fs::path& cache) {
  return assets::open_catalogue(options_for(trusted, cache, true)).ok();
}

bool make_room(bool trusted, const fs::path& cache) {
  auto catalogue = assets::open_catalogue(options_for(trusted, cache, false));
  if (!catalogue) return false;
  const auto library = make_first_of({*std::move(catalogue), create::make_created_library()});
  auto designer = make_rule_designer();
  PlanRequest request;
  request.prompt = "a cosy bedroom for two with a desk by the wall";
  const auto plan = designer->plan(request);
  return plan && generate(*plan, *designer, *library, KindTable::built_in(), {}).ok();
}

template <typename Work>
bool compare(const char* name, int runs, Work work) {
  double least[2] = {1e9, 1e9};
  for (int run = 0; run <= runs; ++run)
    for (const bool trusted : {false, true}) {
      const double start = processor_seconds();
      if (!work(trusted)) return std::printf("%s failed\n", name), false;
      if (run > 0) least[trusted] = std::min(least[trusted], processor_seconds() - start);  // the first one reads words
    }
  std::printf("| %s | %.2f | %.2f | %.2f |\n", name, least[0], least[1], least[0] / least[1]);
  return true;
}

}  // namespace

int main() {
  if (assets::installed_libraries().empty()) return std::puts("(no furniture)"), 0;
  const fs::path cache = fs::temp_directory_path() / ("roomgen-decoding-" + std::to_string(getpid()));
  fs::create_directories(cache);
  std::puts("| | a process of its own, s | this process, s | times |\n|---|---|---|---|");
  const bool done = compare("index", index_runs, [&](bool trusted) { return index(trusted, cache); }) &&
                    compare("a bedroom, warm", room_runs, [&](bool trusted) { return make_room(trusted, cache); });
  fs::remove_all(cache);
  return done ? 0 : 1;
}
