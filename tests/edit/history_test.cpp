#include "history.h"

#include <map>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "fragile_disk.h"
#include "journal.h"
#include "small_scenes.h"

using namespace roomgen;

namespace {

std::shared_ptr<FragileDisk> disk_with(const std::string& scene_text) {
  auto disk = std::make_shared<FragileDisk>();
  disk->scene = scene_text;
  return disk;
}

History opened(const std::shared_ptr<FragileDisk>& disk) {
  auto history = History::open(FragileDisk::files(disk));
  INFO((history ? "" : history.error().message));
  REQUIRE(history);
  return *std::move(history);
}

Scene scene_of(const History& history) { return *scene_from_json(history.state().document, "state"); }

void commit_change(History& history, Random& random) {
  REQUIRE(history.commit(changed_by_chance(scene_of(history), random), {"a change"}));
}

// Indented as no program of ours does it.
std::string handwritten(const Scene& scene) { return to_json(scene).dump(7) + "\n\n"; }

}  // namespace

TEST_CASE("Undoing everything gives the first bytes back, and redoing everything the last") {
  for (int seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const std::string first = handwritten(row_of_boxes(8));
    const auto disk = disk_with(first);
    auto history = opened(disk);
    std::vector<std::string> texts = {first};
    for (int step = 0; step < 120; ++step) {
      commit_change(history, random);
      if (history.state().text != texts.back()) texts.push_back(history.state().text);
      if (step % 40 == 7) history = opened(disk);
    }
    const std::string last = history.state().text;
    REQUIRE(history.save());
    history = opened(disk);
    CHECK(*history.undo(1, "test") == 1);
    CHECK(history.state().text == texts[texts.size() - 2]);
    REQUIRE(history.save());
    history = opened(disk);
    CHECK(*history.undo(1000, "test") >= texts.size() - 2);
    CHECK(history.state().text == first);
    CHECK(*history.undo(1, "test") == 0);
    REQUIRE(history.save());
    CHECK(disk->scene == first);
    history = opened(disk);
    CHECK(*history.redo(1000, "test") >= texts.size() - 1);
    CHECK(history.state().text == last);
    CHECK(*history.redo(1, "test") == 0);
  }
}

TEST_CASE("Every state is made again from the journal alone") {
  Random random(3);
  const auto disk = disk_with(dump_json(to_json(row_of_boxes(10))));
  auto history = opened(disk);
  std::map<std::size_t, std::string> texts;
  for (int step = 0; step < 200; ++step) {
    if (step % 17 == 5) REQUIRE(history.undo(random.integer(1, 6), "test"));
    if (step % 23 == 3) REQUIRE(history.branch("b" + std::to_string(step), std::nullopt, "test"));
    commit_change(history, random);
    texts[history.state().sequence] = history.state().text;
  }
  const auto all = read_journal(disk->journal, "scene.journal");
  REQUIRE(all);
  Timeline replayed;
  for (const auto& entry : all->entries) replayed.add(entry);
  for (const auto& [sequence, text] : texts) {
    const auto state = replayed.state(sequence);
    REQUIRE(state);
    CHECK(state->text == text);
  }
  CHECK(replayed.head() == history.state().sequence);
}

TEST_CASE("The journal grows with what changed, not with the scene") {
  const auto disk = disk_with(dump_json(to_json(row_of_boxes(400))));
  auto history = opened(disk);
  const std::size_t whole = disk->scene.size(), begun = disk->journal.size();
  Random random(9);
  constexpr int edits = 300;
  for (int i = 0; i < edits; ++i) {
    Scene scene = scene_of(history);
    scene.objects[static_cast<std::size_t>(i)].yaw = 0.5;
    REQUIRE(history.commit(scene, {"turn"}));
  }
  CHECK((disk->journal.size() - begun) / edits < 900);
  CHECK((disk->journal.size() - begun) / edits < whole / 50);
}

TEST_CASE("Branches keep their states apart") {
  Random random(2);
  const auto disk = disk_with(dump_json(to_json(row_of_boxes(5))));
  auto history = opened(disk);
  commit_change(history, random);
  const auto fork = history.state().sequence;
  commit_change(history, random);
  const std::string on_main = history.state().text;
  REQUIRE(history.branch("bold", fork, "test"));
  CHECK(history.timeline().branch() == "bold");
  commit_change(history, random);
  const std::string on_bold = history.state().text;
  REQUIRE(history.branch("main", std::nullopt, "test"));
  CHECK(history.state().text == on_main);
  REQUIRE(history.branch("bold", std::nullopt, "test"));
  CHECK(history.state().text == on_bold);
  CHECK(!history.branch("main", 1, "test"));
  CHECK(!history.branch("new", 4711, "test"));
  CHECK(!history.branch("two\nlines", std::nullopt, "test"));
}

TEST_CASE("A scene.json that was changed by hand wins and becomes an entry") {
  Random random(4);
  const auto disk = disk_with(dump_json(to_json(row_of_boxes(5))));
  auto history = opened(disk);
  commit_change(history, random);
  const std::string edited = history.state().text;
  REQUIRE(history.save());
  const std::string by_hand = handwritten(row_of_boxes(3));
  disk->scene = by_hand;
  history = opened(disk);
  CHECK(history.state().text == by_hand);
  REQUIRE(history.notices().size() == 1);
  commit_change(history, random);
  CHECK(*history.undo(1, "test") == 1);
  CHECK(history.state().text == by_hand);
  CHECK(*history.undo(1, "test") == 1);
  CHECK(history.state().text == edited);
}

TEST_CASE("A scene.json that was broken by hand is told, and the journal still has the room") {
  Random random(4);
  const auto disk = disk_with(dump_json(to_json(row_of_boxes(5))));
  auto history = opened(disk);
  commit_change(history, random);
  const std::string good = history.state().text;
  REQUIRE(history.save());
  disk->scene = good.substr(0, good.size() / 2);
  const auto refused = History::open(FragileDisk::files(disk));
  REQUIRE(!refused);
  CHECK(refused.error().message.find("line") != std::string::npos);
  CHECK(refused.error().message.find("move scene.json away") != std::string::npos);
  disk->has_scene = false;
  history = opened(disk);
  CHECK(history.state().text == good);
  REQUIRE(history.save());
  CHECK(disk->scene == good);
}

TEST_CASE("Looking changes nothing") {
  Random random(4);
  const auto disk = disk_with(dump_json(to_json(row_of_boxes(5))));
  const auto look = [&] { return History::open(FragileDisk::files(disk), SceneAccess::look); };
  REQUIRE(look());
  CHECK(disk->journal.empty());
  auto history = opened(disk);
  commit_change(history, random);
  const std::string journal = disk->journal + "{\"sum\":\"torn";
  disk->journal = journal;
  const auto looking = look();
  REQUIRE(looking);
  CHECK(looking->state().text == history.state().text);
  CHECK(looking->notices().size() == 2);
  CHECK(disk->journal == journal);
}

TEST_CASE("A scene that did not change is no new state") {
  const auto disk = disk_with(dump_json(to_json(row_of_boxes(5))));
  auto history = opened(disk);
  REQUIRE(history.commit(scene_of(history), {"nothing"}));
  CHECK(history.state().sequence == 1);
}

TEST_CASE("A name of a branch has nothing that steers a terminal") {
  const auto disk = disk_with(dump_json(to_json(row_of_boxes(2))));
  auto history = opened(disk);
  for (const char* name : {"\x1b[31mred", "a\nb", "bell\a", "\x7f", "", "-d"}) CHECK(!history.branch(name, std::nullopt, "test"));
  CHECK(history.branch("räume 2", std::nullopt, "test"));
}

TEST_CASE("A journal whose numbers have come to their end takes no more, and keeps what it has") {
  const auto disk = disk_with(dump_json(to_json(row_of_boxes(2))));
  {
    auto history = opened(disk);
    REQUIRE(history.save());
  }
  auto read = read_journal(disk->journal, "scene.journal");
  REQUIRE(read);
  read->entries.front().sequence = max_sequence;
  disk->journal = journal_lines(read->entries, true);
  const std::string before = disk->journal;
  auto history = opened(disk);
  const auto status = history.commit(row_of_boxes(3), {"one more"});
  REQUIRE(!status);
  CHECK(status.error().kind == Error::Kind::limit);
  CHECK(disk->journal == before);
}
