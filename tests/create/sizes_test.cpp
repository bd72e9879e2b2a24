#include <cmath>

#include "catch.h"
#include "rule_steps.h"
#include "relative_size.h"
#include "roomgen/create/create.h"
#include "roomgen/create/maker.h"
#include "settings.h"

using namespace roomgen;
using namespace roomgen::create;

namespace {

Vec3 size_of(const ShapeKind& kind, Description description, std::uint64_t seed = 1) {
  const auto& kinds = *ShapeKinds::built_in();
  const auto parameters = shape::describe_parameters(*kinds.recipe(kind.recipe), kind.recipe);
  REQUIRE(parameters);
  description.kind = description.noun = kind.name;
  return choose_settings(description, kind, *parameters, *built_in_words(), seed).size;
}

Vec3 size_of(const std::string& kind, const Description& description) {
  return size_of(*ShapeKinds::built_in()->find(kind), description);
}

Description counted(const std::string& label, int count) {
  Description description;
  description.parts.emplace_back();
  description.parts.back().label = label;
  description.parts.back().count = count;
  return description;
}

Description saying(const std::string& prompt) {
  Description description;
  description.prompt = prompt;
  return description;
}

}  // namespace

TEST_CASE("Every kind stays in its range, whatever scale word is said") {
  for (const auto& [name, kind] : ShapeKinds::built_in()->all())
    for (const auto& [word, factors] : built_in_words()->scales) {
      Description description;
      description.scale = factors;
      const Vec3 size = size_of(kind, description);
      INFO(word << " " << name << ": " << size.transpose());
      CHECK(((size - kind.least).array() >= -0.002).all());
      CHECK(((kind.most - size).array() >= -0.002).all());
    }
}

TEST_CASE("A scale word goes its way, and lengths in numbers go as far as they say") {
  for (const char* name : {"bookcase", "wardrobe", "stool", "dining table", "chair"}) {
    Description usual, tall, told;
    tall.scale.z() = 1.25;
    told.size = Vec3(std::nan(""), std::nan(""), 1.9);
    CHECK(size_of(name, tall).z() > size_of(name, usual).z());
  }
  Description told;
  told.size = Vec3(std::nan(""), std::nan(""), 2.9);
  CHECK(size_of("bookcase", told).z() == 2.9);
}

TEST_CASE("More of what stands side by side makes a thing wider, more above each other higher") {
  struct Case {
    const char *kind, *label;
    int axis, few, many;
  };
  for (const Case& c : {Case{"wardrobe", "door", 0, 2, 6}, Case{"filing cabinet", "drawer", 2, 2, 5},
                        Case{"bookshelf", "shelf", 2, 3, 7}, Case{"coat hooks", "hook", 0, 3, 15},
                        Case{"chest of drawers", "drawer", 2, 3, 7}, Case{"sofa", "cushion", 0, 2, 5},
                        Case{"shoe rack", "shelf", 2, 2, 6}, Case{"step stool", "step", 2, 1, 3}}) {
    double last = 0.0;
    for (int count = c.few; count <= c.many; ++count) {
      const double side = size_of(c.kind, counted(c.label, count))[c.axis];
      INFO(count << " of " << c.label << " on a " << c.kind << ": " << side);
      CHECK(side >= last);
      last = side;
    }
    CHECK(last > 1.15 * size_of(c.kind, counted(c.label, c.few))[c.axis]);
  }
}

TEST_CASE("A table is as long as its guests need") {
  double last = 0.0;
  for (const char* prompt : {"a dining table for two", "a table for 4 people", "a table for six",
                             "an eight-seater dining table", "a dining table that seats ten"}) {
    const double width = size_of("dining table", saying(prompt)).x();
    INFO(prompt << ": " << width);
    CHECK(width > last);
    last = width;
  }
  CHECK(last > 2.4);
  CHECK_FALSE(read_relative_size("a rack for ten bottles").people);
  CHECK_FALSE(read_relative_size("a single table").people);
}

TEST_CASE("Heights of the body and of things are lengths") {
  CHECK(read_relative_size("a potted plant about knee height").height == 0.5);
  CHECK(read_relative_size("a waist-high vase").height == 1.0);
  CHECK(read_relative_size("a shelf that comes up to my shoulder").height == 1.4);
  CHECK(read_relative_size("an hourglass that is taller than a child").height.value_or(0) > 1.15);
  CHECK(read_relative_size("a bookcase as tall as a door").height == 2.0);
  CHECK(read_relative_size("a table lamp shorter than a dog").height.value_or(1) < 0.6);
  // Of a part, or of nothing.
  CHECK(read_relative_size("a chair with a waist-high back").empty());
  CHECK(read_relative_size("a chair with a headrest and a seat").empty());
  CHECK(read_relative_size("a high table").empty());
}

TEST_CASE("Multiples are against the usual size") {
  CHECK(read_relative_size("a sofa twice as wide as usual").factor == Vec3(2, 1, 1));
  CHECK(read_relative_size("a stool half the normal height").factor == Vec3(1, 1, 0.5));
  CHECK(read_relative_size("a half-height bookcase").factor == Vec3(1, 1, 0.5));
  CHECK(read_relative_size("a lamp three times the usual size").factor == Vec3(3, 3, 3));
  CHECK(read_relative_size("a double bed").empty());
  CHECK(read_relative_size("a half round table, twice as tall as a chair").empty());
  const auto& stool = *ShapeKinds::built_in()->find("stool");
  const auto size = said_size(saying("a stool half the usual height"), &stool);
  REQUIRE(size);
  CHECK(size->z() == 0.5 * stool.size.z());
  CHECK(std::isnan(size->x()));
  CHECK_FALSE(said_size(saying("a stool"), &stool));
}

TEST_CASE("Small things blown up keep their proportions") {
  const Vec3 size = size_of("hourglass", saying("an hourglass taller than a child"));
  CHECK(size.z() > 1.15);
  CHECK(size.x() > 0.3);
}

TEST_CASE("A place or a part may name a nearer kind") {
  const auto& kinds = *ShapeKinds::built_in();
  const auto closer = [&](const std::string& noun, const std::string& prompt, const std::string& label) {
    Description description = label.empty() ? Description() : counted(label, 6);
    description.noun = noun;
    description.prompt = prompt;
    description.kind = kinds.find(noun)->name;
    const ShapeKind* kind = closer_kind(description, kinds);
    return kind ? kind->name : "";
  };
  CHECK(closer("coat rack", "a coat rack for the wall", "") == "coat hooks");
  CHECK(closer("lamp", "a wall-mounted lamp", "") == "wall lamp");
  CHECK(closer("chest", "a chest of six drawers", "drawer") == "chest of drawers");
  CHECK(closer("ladder", "a ladder that leans against the wall", "").empty());
  CHECK(kinds.find("wall shelf")->name == "wall shelf");
  CHECK(kinds.find("wall shelves")->name == "wall shelves");
}

TEST_CASE("What is made is as large as its kind may be") {
  const auto maker = make_rule_maker();
  for (const char* prompt : {"a tall bookcase with five shelves", "a tiny stool with three slanted legs",
                             "a huge wardrobe with eight doors", "a small step stool with two steps",
                             "a large bar cart with two trays", "a narrow desk with splayed legs"}) {
    const auto made = create::create(prompt, *maker, {.seed = 1});
    REQUIRE(made);
    const auto& object = made->objects.at(0);
    const ShapeKind& kind = *ShapeKinds::built_in()->find(object.description.kind);
    const Vec3 size = bounds(object.shape).size();
    INFO(prompt << ": " << size.transpose());
    CHECK(((size - kind.least).array() >= -0.006).all());
    CHECK(((kind.most - size).array() >= -0.006).all());
  }
}

TEST_CASE("The height that is said of a part is the part's") {
  const auto maker = make_rule_maker();
  Description throne = saying("a throne with a back two metres tall");
  throne.noun = throne.kind = "throne";
  throne.parts.emplace_back();
  throne.parts.back().label = "back";
  throne.parts.back().size = Vec3(std::nan(""), std::nan(""), 2.0);
  const auto made = create_described(throne, *maker, {.seed = 1});
  REQUIRE(made);
  const double height = bounds(made->shape).size().z();
  CHECK(height > 1.99);
  CHECK(height < 2.9);
}
