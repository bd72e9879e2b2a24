// Sizes that sentences tell of things that come or take another's place, lists of which one is meant, plurals.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "comparison.h"
#include "edit_words.h"
#include "roomgen/base/file.h"
#include "roomgen/create/create.h"
#include "roomgen/edit/session.h"
#include "roomgen/edit_reader/understand.h"
#include "support/rooms.h"
#include "support/temporary_folder.h"

using namespace roomgen;

namespace {

Scene sitting_room() {
  Room room = rooms::box(6.0, 5.0);
  room.openings = {rooms::door("door-0", 0, 0.3, 1.2), rooms::window("window-0", 2, 0.5, 1.5),
                   rooms::window("window-1", 2, 3.5, 5.0)};
  return rooms::scene(room, {rooms::thing("sofa-0", "sofa", {2.0, 0.9, 0.8}, {3.0, 4.4}),
                             rooms::thing("coffee table-0", "coffee table", {1.0, 0.6, 0.4}, {3.0, 2.5}),
                             rooms::thing("dining table-0", "dining table", {1.6, 0.9, 0.75}, {4.5, 1.0})});
}

Result<std::vector<edit::Operation>> operations_here(const std::string& sentence) {
  const Scene scene = sitting_room();
  const auto understood = read_edit(sentence, scene, KindTable::built_in(), {});
  if (!understood) return understood.error();
  return understood->operations;
}

std::string read_here(const std::string& sentence) {
  const auto operations = operations_here(sentence);
  if (!operations) return operations.error().message;
  std::string text;
  for (const auto& one : *operations) text += (text.empty() ? "" : "; ") + edit::to_json(one).dump();
  return text;
}

edit::Add added_by(const std::string& sentence) {
  INFO(sentence);
  const auto operations = operations_here(sentence);
  REQUIRE(operations);
  const auto* add = std::get_if<edit::Add>(&operations->front());
  REQUIRE(add);
  return *add;
}

}  // namespace

TEST_CASE("A measure before a new thing is its size and no number") {
  const edit::Add sofa = added_by("add a 3 m sofa");
  CHECK(sofa.count == 1);
  CHECK(sofa.description == "sofa");
  REQUIRE(sofa.size);
  CHECK(sofa.size->x() == 3.0);
  const edit::Add desks = added_by("add two 1.2 m wide desks");
  CHECK(desks.count == 2);
  REQUIRE(desks.size);
  CHECK(desks.size->x() == 1.2);
  const edit::Add rug = added_by("add a rug of 2 x 3 m");
  REQUIRE(rug.size);
  CHECK(rug.size->head<2>() == Vec2(2.0, 3.0));
  CHECK(!added_by("add three sofas").size);
  CHECK(added_by("add three sofas").count == 3);
}

TEST_CASE("A measure tells which thing is meant") {
  CHECK(read_here("remove the 1.6 m table") == R"({"do":"remove","objects":["dining table-0"]})");
  CHECK(read_here("remove the 3 m sofa").find("nothing in the room") == 0);
}

TEST_CASE("Of things that are listed the one is meant that is so") {
  CHECK(read_here("paint the smaller of the coffee table and the dining table black") ==
        R"({"do":"recolor","object":"coffee table-0","looks":"black"})");
  CHECK(read_here("paint the larger of the sofa and the coffee table black") ==
        R"({"do":"recolor","object":"sofa-0","looks":"black"})");
}

TEST_CASE("Several windows are each of them") {
  const std::string each = R"({"do":"add","category":"curtain","description":"curtains","relations":["near, window-0"]}; )"
                           R"({"do":"add","category":"curtain","description":"curtains","relations":["near, window-1"]})";
  CHECK(read_here("add curtains to the windows") == each);
  CHECK(read_here("add curtains to both windows") == each);
  CHECK(read_here("add curtains to the window").find("say which window") != std::string::npos);
}

TEST_CASE("So many on each side are twice as many in all") {
  const auto operations = operations_here("put two plants on each side of the sofa");
  REQUIRE(operations);
  REQUIRE(operations->size() == 2);
  for (const auto& one : *operations) CHECK(std::get<edit::Add>(one).count == 2);
  const auto shared = operations_here("put two plants on either side of the sofa");
  REQUIRE(shared);
  for (const auto& one : *shared) CHECK(std::get<edit::Add>(one).count == 1);
}

TEST_CASE("What comes with a table stands at it as such things do") {
  const std::string text = read_here("add a dining table with four chairs");
  CHECK(text.find(R"("count":4,"relations":["around, dining table-1"])") != std::string::npos);
}

TEST_CASE("A replacement is as it is compared, or none comes") {
  const auto holds_for = [](const char* words, const Vec3& is) {
    return holds(comparison_in(words), is, Vec3(2.0, 0.9, 0.8));
  };
  CHECK(holds_for("wider sofa", {2.2, 0.9, 0.8}));
  CHECK(!holds_for("wider sofa", {2.0, 1.2, 0.8}));
  CHECK(!holds_for("bigger sofa", {0.9, 0.9, 1.9}));
  CHECK(holds_for("lower sofa", {2.0, 0.9, 0.7}));
  CHECK(!holds_for("lower sofa", {2.0, 0.9, 0.79}));
  CHECK(comparison_in("much wider oak sofa").description == "oak sofa");

  static const auto library = create::make_finishing_library(create::make_created_library());
  const std::pair<const char*, int> cases[] = {{"replace the sofa with a wider one", 0},
                                               {"replace the dining table with a bigger one", 0},
                                               {"swap the coffee table for a lower one", 2}};
  for (const auto& [sentence, axis] : cases) {
    INFO(sentence);
    const TemporaryFolder folder;
    REQUIRE(write_file(folder / "scene.json", dump_json(to_json(sitting_room()))));
    auto session = Session::open(folder / "scene.json", *library, KindTable::built_in());
    REQUIRE(session);
    const Scene before = session->scene();
    const auto understood = understand(*session, sentence);
    REQUIRE(understood);
    const auto report = session->apply(understood->operations);
    INFO((report ? "" : report.error().message));
    REQUIRE(report);
    const std::string id = std::get<edit::Replace>(understood->operations.front()).object;
    const double is = find_object(session->scene(), id)->size[axis], was = find_object(before, id)->size[axis];
    if (axis == 2) CHECK(is < was);
    else CHECK(is > was);
  }
}

TEST_CASE("The only door stays, and another may go") {
  static const auto library = create::make_finishing_library(create::make_created_library());
  const TemporaryFolder folder;
  REQUIRE(write_file(folder / "scene.json", dump_json(to_json(sitting_room()))));
  auto session = Session::open(folder / "scene.json", *library, KindTable::built_in());
  REQUIRE(session);
  const std::vector<edit::Operation> close = {edit::Close{{"door-0"}}};
  const auto refused = session->apply(close);
  REQUIRE(!refused);
  CHECK(refused.error().message.find("add another door first") != std::string::npos);
  const std::vector<edit::Operation> open = {edit::Open{"door"}, edit::Close{{"door-0"}}};
  CHECK(session->apply(open));
}

TEST_CASE("What no part of a thing can be is refused and not said to be done") {
  static const auto library = create::make_finishing_library(create::make_created_library());
  const TemporaryFolder folder;
  REQUIRE(write_file(folder / "scene.json", dump_json(to_json(sitting_room()))));
  auto session = Session::open(folder / "scene.json", *library, KindTable::built_in());
  REQUIRE(session);
  REQUIRE(session->apply(std::vector<edit::Operation>{edit::Replace{"coffee table-0", "", "oak coffee table"}}));
  const auto glass = session->apply(std::vector<edit::Operation>{edit::Recolor{"coffee table-0", "glass"}});
  REQUIRE(!glass);
  CHECK(glass.error().message.find("replace coffee table-0 with a glass coffee table") != std::string::npos);
  CHECK(session->apply(std::vector<edit::Operation>{edit::Recolor{"coffee table-0", "walnut"}}));
}

TEST_CASE("A taller back makes a made thing taller, by its program") {
  static const auto library = create::make_finishing_library(create::make_created_library());
  const TemporaryFolder folder;
  REQUIRE(write_file(folder / "scene.json", dump_json(to_json(sitting_room()))));
  auto session = Session::open(folder / "scene.json", *library, KindTable::built_in());
  REQUIRE(session);
  REQUIRE(session->apply(std::vector<edit::Operation>{edit::Replace{"coffee table-0", "", "wooden pew"}}));
  const auto pew = [&] {
    for (const auto& object : session->scene().objects)
      if (object.asset.procedural) return object;
    return Object();
  };
  const Object before = pew();
  REQUIRE(before.asset.procedural);
  const auto report = session->apply(std::vector<edit::Operation>{edit::Reform{before.id, "with taller back"}});
  INFO((report ? "" : report.error().message));
  REQUIRE(report);
  CHECK(pew().size.z() > 1.1 * before.size.z());
  CHECK(pew().size.head<2>() == before.size.head<2>());
  CHECK(pew().asset.procedural->params != before.asset.procedural->params);
  // What names neither a measure nor a form changes nothing.
  CHECK(!session->apply(std::vector<edit::Operation>{edit::Reform{before.id, "with happier back"}}));
}

TEST_CASE("What is wrong with a scene that was made by hand is told when it is opened") {
  static const auto library = create::make_finishing_library(create::make_created_library());
  const TemporaryFolder folder;
  Scene scene = sitting_room();
  REQUIRE(write_file(folder / "scene.json", dump_json(to_json(scene))));
  {
    const auto sound = Session::open(folder / "scene.json", *library, KindTable::built_in());
    REQUIRE(sound);
    CHECK(sound->notices().empty());
  }
  scene.objects[1].position = scene.objects[0].position;
  scene.objects[2].position.x() = 9.0;
  REQUIRE(write_file(folder / "scene.json", dump_json(to_json(scene))));
  const auto opened = Session::open(folder / "scene.json", *library, KindTable::built_in());
  REQUIRE(opened);
  std::string all;
  for (const auto& notice : opened->notices()) all += notice + "\n";
  CHECK(all.find("overlap: coffee table-0 and sofa-0") != std::string::npos);
  CHECK(all.find("outside: dining table-0") != std::string::npos);
}
