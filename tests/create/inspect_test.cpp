#include "programs.h"

using namespace roomgen;
using create::Footing;
using create::inspect;

namespace {

create::Soundness inspected(const shape::Program& program, Footing footing = Footing::ground) {
  create::ValidateOptions options;
  options.footing = footing;
  const auto soundness = inspect(program, options);
  REQUIRE(soundness);
  for (const auto& problem : soundness->problems) UNSCOPED_INFO(problem);
  return *soundness;
}

const char* const post = R"({"name": "post", "label": "post", "box": {"size": [0.1, 0.1, 0.5]}})";

}  // namespace

TEST_CASE("A thing in one piece that stands has no problems") {
  const auto stool = inspected(runged_stool());
  CHECK(stool.bodies == 7);
  CHECK(stool.pieces == 1);
  CHECK(stool.sound());
  CHECK(stool.supported);
  CHECK(stool.congruent);
  CHECK(stool.stability == Approx(0.185).margin(0.01));
  CHECK(stool.problems.empty());
}

TEST_CASE("Gaps, pieces and heights are measured on the meshes") {
  const auto apart = inspected(
      program(std::string(post) +
                  R"(, {"name": "top", "box": {"size": [0.3, 0.3, 0.02]}, "at": [0, 0, 0.514]})",
              R"(["top", "post"])"));
  CHECK(apart.pieces == 2);
  CHECK_FALSE(apart.supported);
  REQUIRE(apart.open_connections.size() == 1);
  CHECK(apart.open_connections.front() == "top and post: 14 mm apart");
  const auto hovering =
      inspected(program(R"({"name": "ball", "box": {"size": [1, 1, 1]}, "at": [0, 0, 0.05]})"));
  CHECK_FALSE(hovering.grounded);
  CHECK_FALSE(hovering.sound());
}

TEST_CASE("The boxes of a ring and its middle overlap, the meshes do not touch") {
  const auto ring = inspected(program(
      R"({"name": "ring", "lathe": {"profile": [[0.2, 0], [0.22, 0], [0.22, 0.1], [0.2, 0.1]], "corners": "all", "closed": true}},
         {"name": "middle", "cylinder": {"radius": 0.1, "height": 0.1}})"));
  CHECK(ring.pieces == 2);
}

TEST_CASE("A thing whose centre of mass is beside its foot tips over") {
  const std::string arm =
      R"(, {"name": "arm", "box": {"size": [0.6, 0.1, 0.1]}, "at": [0.3, 0, 0.5]})";
  const auto tips = inspected(program(post + arm));
  CHECK(tips.pieces == 1);
  CHECK_FALSE(tips.stable);
  CHECK(tips.stability < 0);
  CHECK(inspected(program(post + arm), Footing::wall).sound());
}

TEST_CASE("Each copy must touch what it is declared to touch") {
  const auto stool = inspected(program(
      R"({"name": "seat", "label": "seat", "box": {"size": [0.3, 0.4, 0.03]}, "at": [0, 0, 0.4]},
         {"name": "leg", "label": "leg", "box": {"size": [0.03, 0.03, 0.4]}, "at": [0.1, 0.1, 0],
          "operations": [{"array": {"count": 2, "step": [0.2, 0, 0]}}, {"mirror": "y"}]})",
      R"(["leg", "seat"])"));
  CHECK(stool.open_connections.size() == 2);
  CHECK(stool.pieces == 3);
}

TEST_CASE("A group is joined when anything in it is") {
  const auto chair = inspected(example("chair"));
  CHECK(chair.open_connections.empty());
  const auto in_group =
      inspected(program(std::string(post) + R"(, {"name": "rest", "group": {"components": [
        {"name": "low", "box": {"size": [0.1, 0.1, 0.1]}}, {"name": "high", "box": {"size": [0.1, 0.1, 0.1]}, "at": [0, 0, 0.1]}]}, "at": [0, 0, 0.5]})",
                        R"(["rest", "post"])"));
  CHECK(in_group.open_connections.empty());
}

TEST_CASE("Standing on a corner is no connection") {
  const auto corner = inspected(program(
      R"({"name": "slab", "label": "slab", "box": {"size": [0.4, 0.4, 0.05]}},
         {"name": "cone", "label": "cone", "frustum": {"bottom_radius": 0, "top_radius": 0.1, "height": 0.1}, "at": [0, 0, 0.0505]})",
      R"(["cone", "slab"])"));
  REQUIRE(corner.open_connections.size() == 1);
  CHECK(corner.open_connections.front() == "cone and slab: only a point");
}

TEST_CASE("A short leg of four is found although the rest stands") {
  const auto table = inspected(program(
      R"({"name": "top", "label": "top", "box": {"size": [1, 0.6, 0.03]}, "at": [0, 0, 0.7]},
         {"name": "leg", "label": "leg", "box": {"size": [0.05, 0.05, 0.7]}, "at": [0.4, 0.2, 0], "operations": [{"mirror": "x"}]},
         {"name": "left", "label": "front leg", "box": {"size": [0.05, 0.05, 0.7]}, "at": [-0.4, -0.2, 0]},
         {"name": "right", "label": "front leg", "box": {"size": [0.05, 0.05, 0.62]}, "at": [0.4, -0.2, 0.08]})"));
  REQUIRE(table.open_connections.size() == 1);
  CHECK(table.open_connections.front() == "right and the floor: 80 mm apart");
}

TEST_CASE("What somebody drew stays as drawn: what floats is told, what nearly touches is not") {
  const std::string drawn = R"({"components": [
      {"name": "top", "label": "seat", "box": {"size": [0.4, 0.4, 0.03]}, "at": [0, 0, 0.41]},
      {"name": "leg", "label": "leg", "box": {"size": [0.04, 0.04, 0.4]}, "at": [0.15, 0.15, 0],
       "operations": [{"mirror": "x"}, {"mirror": "y"}]},
      {"name": "spark", "label": "knob", "box": {"size": [0.02, 0.02, 0.02]}, "at": [0, 0, 0.5],
       "operations": [{"array": {"count": 2, "step": [0.02, 0, 0]}}]}],
    "connections": [["leg", "top"], ["spark", "leg"]]})";
  create::Description stool;
  stool.noun = "stool";
  const auto made = create::create_written(drawn, stool, Mount::floor);
  REQUIRE(made);
  CHECK(made->repairs.empty());
  REQUIRE(made->shape.bodies.size() == 7);
  CHECK(bounds(made->shape.bodies.front().mesh).low.z() == Approx(0.41));
  CHECK(bounds(made->shape.bodies.back().mesh).low.z() == Approx(0.5));
  CHECK(made->soundness.problems ==
        std::vector<std::string>{"falls into 2 pieces; loose: spark-0 and 1 more (60 mm from the rest)"});
}
