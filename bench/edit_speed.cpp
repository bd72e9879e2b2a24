// Times edits in an open session of 40 things, without pictures, previews, and opening a long journal. Prints a
// table in Markdown; --show names the slow edits.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "edited_rooms.h"
#include "random_edits.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/edit/session.h"
#include "support/temporary_folder.h"

namespace {

using namespace roomgen;

constexpr std::size_t things = 40;
constexpr double slow = 100.0;  // milliseconds, from which --show names an edit
constexpr int edits = 300, previews = 3000, entries = 1000, openings = 20;

/// Milliseconds of one call.
struct Time {
  double wall = 0.0, processor = 0.0;
};

Time time_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  const auto processor = std::clock();
  work();
  return {std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count(),
          1000.0 * static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC};
}

using Times = std::vector<Time>;

double at_share(const Times& times, double Time::* which, double share) {
  std::vector<double> values;
  for (const auto& time : times) values.push_back(time.*which);
  std::sort(values.begin(), values.end());
  if (values.empty()) return 0.0;
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

void print(const std::string& what, const Times& times) {
  std::printf("| %s | %zu |", what.c_str(), times.size());
  for (const auto which : {&Time::processor, &Time::wall})
    for (const double share : {0.5, 0.95, 0.99, 1.0}) std::printf(" %.1f |", at_share(times, which, share));
  std::puts("");
}

// The last things of the plan go until so many are left.
void keep_forty(Scene& scene) {
  while (scene.objects.size() > things) {
    const std::string id = scene.objects.back().id;
    std::erase_if(scene.objects, [&](const Object& one) { return one.id == id || one.on == id; });
  }
}

// Each edit is made to the same scene: it is undone, which is not timed.
void time_edits(Session& session, bool show) {
  Random random(5);
  Times plain, repaired, refused;
  std::map<std::string, Times> by_sort;
  for (int i = 0; i < edits; ++i) {
    const auto operation = bench::random_edit(session.scene(), random);
    Result<EditReport> report = EditReport();
    const Time time = time_of([&] { report = session.apply({&operation, 1}); });
    (!report ? refused : report->repairs.empty() ? plain : repaired).push_back(time);
    if (report && report->repairs.empty()) by_sort[bench::sort_of(operation)].push_back(time);
    if (time.processor > slow && show) std::fprintf(stderr, "%.0f ms %s\n", time.processor, edit::to_json(operation).dump().c_str());
    if (report) (void)session.undo(1);
  }
  for (const auto& [sort, times] : by_sort) print(sort, times);
  print("all that need no repair", plain);
  print("with repairs", repaired);
  print("refused, with the search for what is in the way", refused);
}

void time_previews(Session& session) {
  Random random(6);
  Times times;
  for (int i = 0; i < previews; ++i) {
    const Object& one = random.pick(session.scene().objects);
    WantedPose pose{one.position.head<2>(), one.yaw};
    for (int axis = 0; axis < 2; ++axis) pose.position[axis] += random.uniform(-1.0, 1.0);
    times.push_back(time_of([&] { (void)session.preview(one.id, pose); }));
  }
  print("`preview`", times);
}

void make_entries(Session& session) {
  Random random(7);
  while (session.history().size() < entries) {
    const Object& one = random.pick(session.scene().objects);
    const edit::Operation lock = edit::Lock{{one.id}, !one.locked};
    (void)session.apply({&lock, 1});
  }
  (void)session.save();
}

void time_openings(const std::filesystem::path& file, const AssetLibrary& library) {
  Times times;
  for (int i = 0; i < openings; ++i)
    times.push_back(time_of([&] { (void)Session::open(file, library, KindTable::built_in()); }));
  print("opening a session with 1,000 entries", times);
}

}  // namespace

int main(int count, char**) {
  const auto library = bench::open_furniture();
  Scene scene = bench::full_room(*library);
  keep_forty(scene);
  const TemporaryFolder folder;
  const auto file = folder / "scene.json";
  if (!write_file(file, dump_json(to_json(scene)))) return 1;
  std::printf("| in a room of %zu things, ms | number | processor: median | p95 | p99 | most | wall: median | p95 | p99 | most "
              "|\n|---|---|---|---|---|---|---|---|---|---|\n",
              scene.objects.size());
  {
    auto session = Session::open(file, *library, KindTable::built_in());
    if (!session) return 1;
    (void)session->models();
    time_edits(*session, count > 1);
    time_previews(*session);
    make_entries(*session);
  }
  time_openings(file, *library);
}
