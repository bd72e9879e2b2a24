// What may become of the files: power cuts at any moment, flipped bytes, other versions, other programs.
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "catch.h"
#include "fragile_disk.h"
#include "history.h"
#include "journal.h"
#include "journal_line.h"
#include "small_scenes.h"

using namespace roomgen;

namespace {

// More are asked for by the environment: ROOMGEN_FAULT_SEEDS=10000.
int seeds() {
  const char* wanted = std::getenv("ROOMGEN_FAULT_SEEDS");
  return wanted ? std::atoi(wanted) : 500;
}

Scene scene_in(const History& history) { return *scene_from_json(history.state().document, "state"); }

/// A person at work until the power goes, with what they were told is done.
struct WorkingDay {
  std::shared_ptr<FragileDisk> disk;
  Random random;
  std::string told;                       ///< the scene after the last call that returned
  std::set<std::size_t> told_entries;     ///< and all entries that were acknowledged
  std::set<std::string> under_way;        ///< what the call that did not return may have come to

  explicit WorkingDay(int seed) : disk(std::make_shared<FragileDisk>()), random(static_cast<std::uint64_t>(seed)) {
    disk->random = random.fork("disk");
    disk->scene = told = dump_json(to_json(row_of_boxes(3)));
  }

  void note(const History& history) {
    told = history.state().text;
    under_way.clear();
    for (const auto& [sequence, entry] : history.timeline().entries()) told_entries.insert(sequence);
  }

  // One call; false when it failed.
  bool step(History& history) {
    const int what = random.integer(0, 9);
    if (what <= 5) {
      const Scene next = changed_by_chance(scene_in(history), random);
      under_way = {dump_json(to_json(next))};
      return history.commit(next, {"change"}).ok() && (!random.chance(0.8) || (note(history), history.save().ok()));
    }
    if (what == 6) {
      const auto to = history.timeline().before(history.state().sequence);
      if (to) under_way = {history.state(*to)->text};
      return history.undo(1, "test").ok();
    }
    if (what == 7) {
      const auto tip = history.timeline().branches().at(history.timeline().branch()).tip;
      const auto to = history.timeline().after(history.state().sequence, tip);
      if (to) under_way = {history.state(*to)->text};
      return history.redo(1, "test").ok();
    }
    if (what == 8) return history.branch("b" + std::to_string(random.integer(0, 99)), std::nullopt, "test").ok();
    return history.save().ok();
  }

  void work_until_the_power_goes() {
    disk->calls_left = random.integer(0, 25);
    auto history = History::open(FragileDisk::files(disk));
    if (!history) return;
    note(*history);
    for (int i = 0; i < 40; ++i) {
      // A branch of that name may be anywhere.
      for (const auto& [name, branch] : history->timeline().branches())
        if (const auto state = history->state(branch.head)) under_way.insert(state->text);
      if (!step(*history)) return;
      note(*history);
    }
  }
};

std::string journal_of_edits(int edits, std::uint64_t seed = 8) {
  const auto disk = std::make_shared<FragileDisk>();
  disk->scene = dump_json(to_json(row_of_boxes(6)));
  auto history = History::open(FragileDisk::files(disk));
  Random random(seed);
  for (int i = 0; i < edits; ++i) {
    Scene scene = scene_in(*history);
    scene.objects[static_cast<std::size_t>(i % 6)].position.x() = 0.01 * random.integer(0, 1100);
    (void)history->commit(scene, {"edit " + std::to_string(i)});
  }
  (void)history->save();
  return disk->journal;
}

std::shared_ptr<FragileDisk> disk_of(const std::string& journal) {
  auto disk = std::make_shared<FragileDisk>();
  const auto reading = read_journal(journal, "scene.journal");
  Timeline timeline;
  for (const auto& entry : reading->entries) timeline.add(entry);
  disk->scene = timeline.state(timeline.head())->text;
  disk->journal = disk->kept_journal = journal;
  return disk;
}

}  // namespace

TEST_CASE("Whenever the power goes, the session opens and nothing acknowledged is missing") {
  int crashes = 0;
  for (int seed = 0; seed < seeds(); ++seed) {
    WorkingDay day(seed);
    for (int days = 0; days < 3; ++days) {
      day.work_until_the_power_goes();
      crashes += day.disk->is_off ? 1 : 0;
      day.disk->restart();
      const auto history = History::open(FragileDisk::files(day.disk), SceneAccess::look);
      INFO("seed " << seed << ", day " << days << ": " << (history ? "" : history.error().message));
      REQUIRE(history);
      const std::string& found = history->state().text;
      REQUIRE((found == day.told || day.under_way.count(found) > 0));
      for (const auto sequence : day.told_entries) REQUIRE(history->timeline().entries().count(sequence) == 1);
      day.told = found;
      for (const auto& [sequence, entry] : history->timeline().entries())
        if (sequence <= history->state().sequence) REQUIRE((!history->timeline().knows(sequence) || history->state(sequence)));
    }
  }
  CHECK(crashes > seeds());
}

TEST_CASE("A flipped byte is located, and all that it does not touch can be used") {
  const std::string journal = journal_of_edits(12);
  Random random(21);
  for (int round = 0; round < 600; ++round) {
    const auto at = static_cast<std::size_t>(random.integer(0, static_cast<int>(journal.size()) - 1));
    const auto disk = disk_of(journal);
    disk->journal[at] = static_cast<char>(disk->journal[at] ^ (1 << random.integer(0, 7)));
    disk->kept_journal = disk->journal;
    const std::string scene = disk->scene;
    auto history = History::open(FragileDisk::files(disk));
    INFO("byte " << at << ": " << (history ? "" : history.error().message));
    REQUIRE(history);
    CHECK(history->state().text == scene);
    REQUIRE(!history->notices().empty());
    CHECK(history->notices().front().find("scene.journal: ") == 0);
    // All states that are written out or lie beside one are still there.
    int lost = 0;
    for (const auto& [sequence, entry] : history->timeline().entries())
      if (history->timeline().knows(sequence) && !history->state(sequence)) ++lost;
    CHECK(lost == 0);
    REQUIRE(history->commit(row_of_boxes(2), {"goes on"}));
  }
}

TEST_CASE("What is behind the last whole line is cut off and told") {
  const std::string journal = journal_of_edits(5);
  const auto last = journal.rfind('\n', journal.size() - 2) + 1;
  for (std::size_t end = last + 1; end < journal.size(); end += 7) {
    const auto disk = disk_of(journal);
    const std::string scene = disk->scene;
    disk->journal.resize(end);
    auto history = History::open(FragileDisk::files(disk));
    REQUIRE(history);
    // scene.json was written after the entry: it is ahead, and is taken over.
    CHECK(history->state().text == scene);
    CHECK(history->notices().size() == 2);
    CHECK(disk->journal.substr(0, last) == journal.substr(0, last));
  }
}

TEST_CASE("A journal of which only a torn beginning was written begins anew") {
  const std::string whole = journal_of_edits(0);
  const auto header = whole.find('\n') + 1;
  for (std::size_t kept = 0; kept < header; kept += 5) {
    const auto disk = std::make_shared<FragileDisk>();
    disk->scene = dump_json(to_json(row_of_boxes(2)));
    disk->journal = whole.substr(0, kept) + std::string(header - kept, '\0') + whole.substr(header + 40);
    auto history = History::open(FragileDisk::files(disk));
    INFO(kept << " bytes: " << (history ? "" : history.error().message));
    REQUIRE(history);
    CHECK(history->state().text == disk->scene);
    CHECK(history->commit(row_of_boxes(3), {"goes on"}));
  }
}

TEST_CASE("A journal of a newer version, and what is none, are refused and left alone") {
  const std::string newer = journal_line(R"({"format":"roomgen-journal","version":2})") + journal_line(R"({"new":1})");
  for (const std::string& bytes : {newer, std::string("dear diary,\n"), std::string("{\"a\":1}\n{\"b\":2}\n")}) {
    const auto disk = std::make_shared<FragileDisk>();
    disk->scene = dump_json(to_json(row_of_boxes(2)));
    disk->journal = bytes;
    const auto history = History::open(FragileDisk::files(disk));
    REQUIRE(!history);
    CHECK(history.error().message.find("scene.journal") == 0);
    CHECK(disk->journal == bytes);
  }
}

TEST_CASE("Entries that nobody could have written are no entries") {
  const std::string good = journal_of_edits(3);
  for (const char* body : {R"({"sequence":3,"kind":"edit","branch":"main","parent":2,"patch":{}})", R"([1,2])",
                           R"({"sequence":99,"kind":"nothing","branch":"main"})", R"({"sequence":-4,"kind":"head"})",
                           R"({"sequence":77,"kind":"edit","branch":"main","parent":4,"patch":{"lists":{"objects":9}}})",
                           R"({"sequence":78,"kind":"head","branch":"main","to":4000})", "17", ""}) {
    const auto disk = disk_of(good);
    disk->journal += journal_line(body);
    const auto history = History::open(FragileDisk::files(disk), SceneAccess::look);
    INFO(body);
    CHECK((history || history.error().message.find("scene.journal") == 0));
  }
}

TEST_CASE("After a write that failed nothing more is written") {
  const auto disk = std::make_shared<FragileDisk>();
  disk->scene = dump_json(to_json(row_of_boxes(2)));
  auto history = History::open(FragileDisk::files(disk));
  disk->calls_left = 0;
  CHECK(!history->commit(row_of_boxes(3), {"lost"}));
  disk->restart();
  CHECK(!history->commit(row_of_boxes(4), {"must not come behind a gap"}));
  CHECK(history->state().document == to_json(row_of_boxes(2)));
}
