#include "timeline.h"

#include <nlohmann/json.hpp>

#include "catch.h"
#include "journal.h"
#include "journal_line.h"
#include "small_scenes.h"

using namespace roomgen;

namespace {

JournalEntry edit_of(std::size_t sequence, std::size_t parent) {
  JournalEntry entry;
  entry.sequence = sequence, entry.parent = parent, entry.branch = "main", entry.patch = "{}";
  return entry;
}

JournalEntry written(std::size_t sequence, const Scene& scene) {
  JournalEntry entry;
  entry.kind = JournalEntry::Kind::scene;
  entry.sequence = sequence, entry.branch = "main", entry.text = dump_json(to_json(scene));
  return entry;
}

// One step back at a time.
std::optional<std::size_t> after_by_walking(const Timeline& timeline, std::size_t sequence, std::size_t tip) {
  for (auto at = tip; at != sequence;) {
    const auto parent = timeline.before(at);
    if (!parent) return std::nullopt;
    if (*parent == sequence) return at;
    at = *parent;
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("The next state on the way to another is the one that walking back finds, damaged entries or not") {
  Random random(7);
  for (int round = 0; round < 60; ++round) {
    Timeline timeline;
    const int count = random.integer(1, 60);
    for (int i = 1; i <= count; ++i) {
      if (random.chance(0.1)) continue;  // its entry is damaged
      // Mostly the one before, so that ways are long.
      const int parent = random.chance(0.8) ? i - 1 : random.integer(0, i - 1);
      timeline.add(edit_of(static_cast<std::size_t>(i), static_cast<std::size_t>(parent)));
    }
    for (std::size_t a = 1; a <= static_cast<std::size_t>(count); ++a)
      for (std::size_t b = 1; b <= static_cast<std::size_t>(count); ++b)
        REQUIRE(timeline.after(a, b) == after_by_walking(timeline, a, b));
  }
}

TEST_CASE("Entries that come of themselves or of later ones are damaged, and said to be") {
  const std::string scene = journal_text(written(1, row_of_boxes(2)));
  for (const char* entry : {R"({"sequence":2,"kind":"edit","branch":"main","parent":2,"patch":{}})",
                            R"({"sequence":2,"kind":"edit","branch":"main","parent":9,"patch":{}})",
                            R"({"sequence":2,"kind":"head","branch":"main","to":2})",
                            R"({"sequence":2,"kind":"snapshot","branch":"main","to":3,"text":"{}"})"}) {
    INFO(entry);
    const auto journal = read_journal(journal_line(scene) + journal_line(entry), "scene.journal");
    REQUIRE(journal);
    CHECK(journal->entries.size() == 1);
    REQUIRE(journal->notices.size() == 1);
    CHECK(journal->notices.front().find("line 2") != std::string::npos);
    CHECK(journal->notices.front().find("is no earlier entry") != std::string::npos);
  }
}

TEST_CASE("An entry is written as it was read") {
  for (const char* entry : {R"({"sequence":3,"kind":"edit","branch":"main","parent":1,"by":"person","asked":"move the \"bed\"",)"
                            R"("operations":[{"do":"lock","objects":["bed"]}],"before":"00","after":"11","patch":{"members":{}}})",
                            R"({"sequence":4,"kind":"head","branch":"a","to":3,"by":"person","asked":"undo"})",
                            R"({"sequence":5,"kind":"snapshot","branch":"main","to":3,"text":"{}"})",
                            R"({"sequence":6,"kind":"scene","branch":"main","parent":3,"by":"file","asked":"","after":"22","text":"{}"})"}) {
    const auto read = parse_entry(entry, "entry");
    REQUIRE(read);
    CHECK(journal_text(*read) == entry);
  }
}

TEST_CASE("A state that is too many changes away is said to be, and not made") {
  constexpr std::size_t most = 20'000;
  Timeline timeline;
  timeline.add(written(1, row_of_boxes(1)));
  for (std::size_t i = 2; i <= most + 2; ++i) timeline.add(edit_of(i, i - 1));
  CHECK(timeline.state(most + 1));
  const auto far = timeline.state(most + 2);
  REQUIRE_FALSE(far);
  CHECK(far.error().message.find("more than 20000 changes") != std::string::npos);
}
