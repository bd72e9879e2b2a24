// Designs that are none: errors say where, other files of the folder are used, and work is bounded.
#include "round_trip.h"

#include <filesystem>
#include <fstream>

#include "book/book.h"

using namespace roomgen;

namespace {

Json sound() {
  return Json::parse(
      R"({"format": "roomgen-design", "version": 1, "name": "a study", "for": ["study"],
    "parameters": {"people": {"default": 2, "least": 1, "most": 4}},
    "size_m": {"usual": ["3 + 0.2*people", 3]}, "room": {"height_m": 2.6},
    "openings": [{"kind": "door", "wall": "south", "at": 0.8}],
    "groups": [{"id": "desk", "stands": {"wall": "north", "along": "W/2"}, "things": [
      {"part": "desk", "name": "desk", "description": "oak desk", "size_cm": [140, 70, 75]},
      {"part": "chair", "name": "office chair", "description": "chair", "quantity": "people", "where": "in front of desk"}]}],
    "objects": [{"name": "bookshelf", "description": "shelf", "size_cm": [80, 30, 180], "stands": {"corner": "north-west"}}]})");
}

std::string refusal(const std::string& pointer, const Json& value) {
  Json design = sound();
  design[Json::json_pointer(pointer)] = value;
  const auto read = book::read_design(design, "bad.json");
  return read ? "" : read.error().message;
}

bool names(const std::string& message, const std::string& part) {
  INFO(message);
  return message.find("bad.json") != std::string::npos && message.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("What is not of the form of designs is refused, with its place") {
  REQUIRE(book::read_design(sound(), "sound"));
  CHECK(names(refusal("/format", "roomgen-plan"), "/format"));
  CHECK(names(refusal("/colour", "red"), "colour"));
  CHECK(names(refusal("/for", Json::array()), "/for"));
  CHECK(names(refusal("/name", 3), "/name"));
  CHECK(names(refusal("/size_m", Json::object()), "/size_m/usual"));
  CHECK(names(refusal("/size_m/usual/0", "3 + chairs"), "/size_m/usual/0"));
  CHECK(names(refusal("/parameters/people/most", 1), "/parameters/people"));
  CHECK(names(refusal("/groups/0/stands/along", "W/("), "/groups/0/stands/along"));
  CHECK(names(refusal("/groups/0/stands/along", "W/0"), "/groups/0/stands/along"));
  CHECK(names(refusal("/groups/0/stands", "by the wall"), "stands"));
  CHECK(names(refusal("/objects/0/stands/corner", "north"), "corner"));
  CHECK(names(refusal("/objects/0/size_cm/0", "shelves"), "/objects/0/size_cm/0"));
}

TEST_CASE("Formulas are bounded, and so is what they make") {
  std::string deep = "1", tall = "W";
  for (int i = 0; i < 200; ++i) deep = "(" + deep + ")", tall += " + 1";
  CHECK(names(refusal("/objects/0/stands", {{"at", {deep, 1}}}), "/objects/0/stands/at/0"));
  CHECK(names(refusal("/objects/0/stands", {{"at", {tall, 1}}}), "/objects/0/stands/at/0"));
  Json huge = sound();
  huge["groups"][0]["things"][1]["quantity"] = "1e12";
  huge["groups"][0]["repeat"] = {{"rows", "1e9"}, {"columns", "1e9"}};
  huge["objects"][0]["size_cm"] = {"1e9", 1e9, 1e9};
  huge["size_m"]["usual"] = {"1e9", 3};
  const auto read = book::read_design(huge, "huge");
  REQUIRE(read);
  CHECK(book::usual_size(*read, book::default_values(*read)).x() <= 50.0);
  int things = 0;
  for (const auto& item : test::plan_of(huge, {50, 3}).items) things += item.quantity;
  CHECK(things <= 400);
}

TEST_CASE("Of a folder with a broken file the others are used, and that is named") {
  const auto folder = std::filesystem::temp_directory_path() / "roomgen-book-test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "a.json") << sound().dump();
  std::ofstream(folder / "b.json") << R"({"name": "half a)";
  std::ofstream(folder / "c.json") << R"({"name": "nowhere", "size_m": {"usual": [3, 3]}})";
  std::ofstream(folder / "notes.txt") << "no design";
  const auto book = book::read_book(folder);
  REQUIRE(book);
  CHECK(book->designs.size() == 1);
  REQUIRE(book->problems.size() == 2);
  CHECK(book->problems[0].find("b.json") != std::string::npos);
  CHECK(book->problems[1].find("/for") != std::string::npos);
  std::filesystem::remove(folder / "a.json");
  CHECK_FALSE(book::read_book(folder));
  CHECK_FALSE(book::read_book(folder / "none"));
  std::filesystem::remove_all(folder);
}

TEST_CASE("A checked design is told by what it is made of") {
  const auto told = check_design(sound(), "sound");
  REQUIRE(told);
  CHECK(*told == "design of 1 groups and 1 single things");
  CHECK_FALSE(check_design(Json::array(), "list"));
}
