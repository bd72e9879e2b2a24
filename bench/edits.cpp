// Random edits of furnished rooms: how many of those that are possible are done, what moves that nobody named,
// whether anything invalid comes in, and whether undo gives the first bytes back. Prints tables in Markdown.
//
//     bench_edits [--edits 200] [--seed 1] [--show] [--keep FOLDER]
//
// --show lists what was refused though possible. --keep writes the first and every fifth state with its meshes
// into the folder, for tests/checker/check_scene.py.

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "edited_rooms.h"
#include "exhaustive.h"
#include "random_edits.h"
#include "roomgen/base/file.h"
#include "roomgen/evaluate/report.h"
#include "roomgen/export/exporter.h"
#include "roomgen/edit/session.h"
#include "support/temporary_folder.h"

namespace {

using namespace roomgen;
namespace fs = std::filesystem;

constexpr int states_between_kept = 5;

struct Options {
  int edits = 200;
  std::uint64_t seed = 1;
  bool show = false;
  fs::path keep;
};

struct Tally {
  int asked = 0, done = 0, repaired = 0, needless_repairs = 0, refused = 0, missed = 0;
};

struct Faults {
  int invalid = 0, moved_silently = 0, states = 0, rooms_given_back = 0, rooms = 0, sampled = 0, too_strict = 0, on_edges = 0;
  std::size_t fewest = 1000, most = 0;
};

std::set<std::string> faults_of(const Scene& scene, const ModelTable& models) {
  std::set<std::string> faults;
  for (const auto& one : examine(scene, models, KindTable::built_in()).violations)
    faults.insert(std::string(name(one.fault)) + " " + one.object + " " + one.other);
  return faults;
}

std::set<std::string> named_in(const edit::Operation& operation) {
  std::set<std::string> ids;
  const auto name = [&](const auto& one) {
    if constexpr (requires { one.object; }) ids.insert(one.object);
    if constexpr (requires { one.objects; }) ids.insert(one.objects.begin(), one.objects.end());
  };
  std::visit(name, operation);
  return ids;
}

void add_loads(const Scene& scene, std::set<std::string>& ids) {
  for (std::size_t before = 0; before != ids.size();) {
    before = ids.size();
    for (const auto& object : scene.objects)
      if (ids.count(object.on)) ids.insert(object.id);
  }
}

bool has_rug(const Scene& scene, const std::set<std::string>& ids) {
  return std::any_of(ids.begin(), ids.end(), [&](const auto& id) {
    const Object* object = find_object(scene, id);
    return object && object->traits.flat;
  });
}

// Of what neither the edit nor its report names.
int count_moved(const Scene& before, const Scene& after, const edit::Operation& operation, const EditReport& report) {
  auto touched = named_in(operation);
  for (const auto& move : report.repairs) touched.insert(move.object);
  add_loads(before, touched);
  const bool may_rise = has_rug(before, touched);  // what stands on a rug
  int moved = 0;
  for (const auto& object : before.objects) {
    if (touched.count(object.id)) continue;
    const Object* now = find_object(after, object.id);
    const bool same = now && now->position.head<2>() == object.position.head<2>() && now->yaw == object.yaw &&
                      now->size == object.size && now->asset == object.asset &&
                      (may_rise || now->position.z() == object.position.z());
    moved += same ? 0 : 1;
  }
  return moved;
}

void keep_state(const fs::path& folder, Session& session) {
  if (!make_folder(folder) || !write_file(folder / "scene.json", session.text()) ||
      !GlbExporter().write(session.scene(), session.models(), folder / "scene.glb"))
    std::fprintf(stderr, "cannot write into %s\n", folder.c_str());
}

class Bench {
 public:
  explicit Bench(const Options& options) : options_(options), library_(bench::open_furniture()) {}

  void run() {
    const auto rooms = bench::rooms_to_edit(*library_);
    for (std::size_t room = 0; room < rooms.size(); ++room)
      edit_room(static_cast<int>(room) + 1, rooms[room], options_.edits / static_cast<int>(rooms.size()));
    print();
  }

 private:
  void edit_room(int number, const Scene& scene, int edits) {
    const TemporaryFolder folder;
    const std::string first = dump_json(to_json(scene));
    if (!write_file(folder / "scene.json", first)) return;
    auto session = Session::open(folder / "scene.json", *library_, KindTable::built_in());
    if (!session) return;
    see(session->scene());
    Random random = Random(options_.seed).fork("room " + std::to_string(number));
    for (int step = 0; step <= edits; ++step) {
      if (!options_.keep.empty() && step % states_between_kept == 0)
        keep_state(options_.keep / ("room-" + std::to_string(number) + "-" + std::to_string(step)), *session);
      if (step < edits) edit(number, *session, bench::random_edit(session->scene(), random));
    }
    ++faults_.rooms;
    if (session->undo(1'000'000) && session->text() == first) ++faults_.rooms_given_back;
  }

  void see(const Scene& scene) {
    faults_.fewest = std::min(faults_.fewest, scene.objects.size());
    faults_.most = std::max(faults_.most, scene.objects.size());
  }

  void edit(int room, Session& session, const edit::Operation& operation) {
    const Scene before = session.scene();
    Tally& tally = tallies_[bench::sort_of(operation)];
    ++tally.asked;
    const auto report = session.apply({&operation, 1});
    if (!report) return refused(room, session, operation, report.error().message);
    ++tally.done;
    if (!report->repairs.empty()) {
      ++tally.repaired;
      if (bench::ExhaustiveCheck(before, session.models(), *library_).possible(operation)) {
        ++tally.needless_repairs;
        show(room, "repaired without need", operation, report->repairs.front().object + " moved");
      }
    }
    ++faults_.states;
    for (const auto& broken : report->broken) faults_.on_edges += broken.find("on the edge of") != std::string::npos ? 1 : 0;
    if (const int moved = count_moved(before, session.scene(), operation, *report); moved > 0) {
      faults_.moved_silently += moved;
      show(room, "moved something silently", operation, "");
    }
    const auto was = faults_of(before, session.models()), is = faults_of(session.scene(), session.models());
    if (!std::includes(was.begin(), was.end(), is.begin(), is.end())) {
      ++faults_.invalid;
      show(room, "let something invalid in", operation, "");
    }
  }

  void refused(int room, Session& session, const edit::Operation& operation, const std::string& why) {
    Tally& tally = tallies_[bench::sort_of(operation)];
    ++tally.refused;
    bench::ExhaustiveCheck check(session.scene(), session.models(), *library_);
    const auto possible = check.possible(operation);
    faults_.sampled += check.sampled(), faults_.too_strict += check.too_strict();
    if (check.too_strict() > 0) show(room, "stricter than check", operation, why);
    if (!possible) return;
    ++tally.missed;
    show(room, "refused", operation, why + "\n    " + join_differences(session.scene(), *possible));
  }

  static std::string join_differences(const Scene& before, const Scene& after) {
    std::string text = "possible: ";
    for (const auto& object : after.objects) {
      const Object* old = find_object(before, object.id);
      if (old && old->position == object.position && old->yaw == object.yaw && old->size == object.size) continue;
      text += object.id + " at " + dump_json(Json{object.position.x(), object.position.y(), object.position.z(), degrees(object.yaw)});
    }
    std::erase(text, '\n');
    return text;
  }

  void show(int room, const char* what, const edit::Operation& operation, const std::string& why) const {
    if (options_.show)
      std::printf("room %d, %s: %s\n    %s\n", room, what, edit::to_json(operation).dump().c_str(), why.c_str());
  }

  void print() const {
    std::puts("| edits | asked | done | of them with repairs | refused | of them possible | done of the possible |\n"
              "|---|---|---|---|---|---|---|");
    Tally all;
    for (const auto& [sort, tally] : tallies_) {
      print_row(sort.c_str(), tally);
      all.asked += tally.asked, all.done += tally.done, all.repaired += tally.repaired;
      all.refused += tally.refused, all.missed += tally.missed, all.needless_repairs += tally.needless_repairs;
    }
    print_row("all", all);
    std::printf("\n%d rooms of %zu to %zu things, %d states: %d invalid, %d things moved silently, %d repairs without "
                "need; undo gave the first bytes back in %d of %d rooms\n",
                faults_.rooms, faults_.fewest, faults_.most, faults_.states, faults_.invalid, faults_.moved_silently,
                all.needless_repairs, faults_.rooms_given_back, faults_.rooms);
    std::printf("%d times the report told of a thing on the edge of a rug\n", faults_.on_edges);
    std::printf("of %d poses that were refused though they fit by their boxes, `check` has nothing against %d\n",
                faults_.sampled, faults_.too_strict);
  }

  static void print_row(const char* name, const Tally& tally) {
    std::printf("| %s | %d | %d | %d | %d | %d | %.1f %% |\n", name, tally.asked, tally.done, tally.repaired,
                tally.refused, tally.missed, 100.0 * tally.done / std::max(1, tally.done + tally.missed));
  }

  Options options_;
  std::unique_ptr<AssetLibrary> library_;
  std::map<std::string, Tally> tallies_;
  Faults faults_;
};

Options options_from(int count, char** arguments) {
  Options options;
  for (int i = 1; i < count; ++i) {
    const std::string name = arguments[i];
    if (name == "--show") options.show = true;
    else if (i + 1 < count && name == "--edits") options.edits = std::atoi(arguments[++i]);
    else if (i + 1 < count && name == "--seed") options.seed = std::strtoull(arguments[++i], nullptr, 10);
    else if (i + 1 < count && name == "--keep") options.keep = arguments[++i];
  }
  return options;
}

}  // namespace

int main(int count, char** arguments) { Bench(options_from(count, arguments)).run(); }
