// The roles of the words of edits, as they are learned from data/language/edits.
#include <algorithm>

#include "catch.h"
#include "edit_words.h"
#include "role_model.h"
#include "roomgen/base/file.h"
#include "support/rooms.h"
#include "train/learn_roles.h"

using namespace roomgen;

namespace {

const std::string folder = std::string(ROOMGEN_DATA) + "/language/edits/";

const MarkedScenes& scenes() {
  static const MarkedScenes all = read_marked_scenes(folder + "scenes.json");
  return all;
}

const std::vector<MarkedEdit>& learned() {
  static const std::vector<MarkedEdit> all = read_marked_edits(folder + "learned.jsonl", scenes());
  return all;
}

Scene living_room() {
  Room room = rooms::box(6.0, 5.0);
  room.openings = {rooms::door("door-0", 0, 0.3, 1.2), rooms::window("window-0", 2, 1.5, 3.0)};
  return rooms::scene(room, {rooms::thing("sofa-0", "sofa", {2.0, 0.9, 0.8}, {3.0, 1.0}),
                             rooms::thing("armchair-0", "armchair", {0.9, 0.9, 0.9}, {1.0, 3.0}),
                             rooms::thing("bookshelf-0", "bookshelf", {1.0, 0.3, 2.0}, {5.0, 4.0}),
                             rooms::thing("floor lamp-0", "floor lamp", {0.4, 0.4, 1.6}, {5.5, 1.0})});
}

Result<Understanding> read(const std::string& sentence) {
  static const Scene scene = living_room();
  return read_edit(sentence, scene, KindTable::built_in(), {});
}

}  // namespace

TEST_CASE("A model that is built in is what the sentences give") {
  const auto bytes = read_file(std::string(ROOMGEN_DATA) + "/language/edit-roles-1.bin");
  REQUIRE(bytes);
  CHECK(learn_roles(lesson_of(learned(), 1)) == *bytes);
}

TEST_CASE("What is all talk changes nothing") {
  std::size_t all = 0;
  for (const auto& edit : learned()) {
    if (std::any_of(edit.roles.begin(), edit.roles.end(), [](EditRole role) { return role != EditRole::idle; })) continue;
    ++all;
    const auto understood = read_edit(edit.text.words_from(0, edit.text.tokens.size()), edit.text.scene,
                                      KindTable::built_in(), {});
    INFO(edit.text.words_from(0, edit.text.tokens.size()));
    CHECK(!understood);
  }
  CHECK(all > 10);
}

TEST_CASE("Reasons and unknown wordings around an order are read over") {
  const auto moved = read("Granny naps in that thing every single day, so please plonk the armchair beside the bookshelf.");
  REQUIRE(moved);
  REQUIRE(moved->operations.size() == 1);
  const auto* move = std::get_if<edit::Move>(&moved->operations.front());
  REQUIRE(move);
  CHECK(move->object == "armchair-0");
}

TEST_CASE("What words that nobody knows may ask for is not done") {
  for (const char* sentence : {"the sofa brillig", "brillig the sofa", "frobnicate everything", "is the sofa comfortable?",
                               "why is the bookshelf empty?", "I remember the day when we bought the sofa"}) {
    INFO(sentence);
    CHECK(!read(sentence));
  }
}

TEST_CASE("Marks that do not cover their sentence are refused with their line") {
  CHECK_THROWS(read_marked_edits(folder + "scenes.json", scenes()));
}
