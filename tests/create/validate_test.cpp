#include <chrono>

#include "programs.h"
#include "sampled_contacts.h"

using namespace roomgen;
using create::Footing;
using create::validate;

namespace {

create::Validation validated(const shape::Program& program, Footing footing = Footing::ground) {
  create::ValidateOptions options;
  options.footing = footing;
  auto result = validate(program, options);
  REQUIRE(result);
  for (const auto& repair : result->repairs) UNSCOPED_INFO("repair: " << repair);
  for (const auto& problem : result->after.problems) UNSCOPED_INFO("left: " << problem);
  return *std::move(result);
}

Bounds3 box_of(const shape::Program& program, const std::string& name) {
  const auto shape = shape::evaluate(program);
  REQUIRE(shape);
  for (const auto& body : shape->bodies)
    if (body.name == name) return bounds(body.mesh);
  FAIL("no body " << name);
  return {};
}

void check_untouched(const shape::Program& program) {
  const auto result = validated(program);
  CHECK(result.before.problems.empty());
  CHECK(result.after.sound());
  CHECK(result.repairs.empty());
  const bool same =
      shape::write_program(result.program).dump() == shape::write_program(program).dump();
  CHECK(same);
}

}  // namespace

TEST_CASE("What is sound stays as it is, to the byte") {
  for (const auto& name : example_names) {
    INFO(name);
    check_untouched(example(name));
  }
  check_untouched(curved_table());
  check_untouched(curved_table(false));
  check_untouched(turned_table());
  check_untouched(dresser());
  check_untouched(runged_stool());
}

TEST_CASE("Examples stay as they are with other parameters") {
  for (const char* kind : {"round", "square"})
    for (double legs : {3.0, 5.0, 6.0})
      check_untouched(example("bar-stool", {{"seat", std::string(kind)}, {"legs", legs}}));
  for (double seats : {1.0, 2.0, 4.0}) check_untouched(example("sofa", {{"seats", seats}}));
  check_untouched(example("chair", {{"legs", std::string("turned")}, {"height", 1.1}}));
}

TEST_CASE("A seat above its legs comes down, or they reach up to it") {
  auto stool = runged_stool();
  stool.components[0].at.z() += 0.06;
  const auto result = validated(stool);
  CHECK_FALSE(result.before.sound());
  CHECK(result.after.sound());
  CHECK(result.after.open_connections.empty());
}

TEST_CASE("Short legs are stretched, so that the seat stays where it was") {
  auto stool = runged_stool();
  std::get<shape::Box>(stool.components[1].solid).size.z() = 0.4;
  const auto result = validated(stool);
  CHECK(result.after.sound());
  CHECK(box_of(result.program, "seat").low.z() == Approx(0.45).margin(0.003));
  CHECK(box_of(result.program, "leg-0").high.z() == Approx(0.452).margin(0.003));
}

TEST_CASE("A rung that is too short reaches both posts again") {
  auto stool = runged_stool();
  auto& rung = stool.components[2];
  std::get<shape::Frustum>(rung.solid).height = 0.26;
  rung.at.x() = -0.13;
  const auto result = validated(stool);
  CHECK(result.after.sound());
  const Bounds3 box = box_of(result.program, "rung-0");
  CHECK(box.low.x() < -0.153);
  CHECK(box.high.x() > 0.153);
}

TEST_CASE("What floats above the ground is set on it") {
  auto stool = runged_stool();
  for (auto& component : stool.components) component.at.z() += 0.3;
  const auto result = validated(stool);
  CHECK(result.after.sound());
  CHECK(result.program.components[0].at.z() == Approx(0.45));
  CHECK(result.repairs.size() == 1);
}

TEST_CASE("Legs outside the outline of what they carry come under it, alike") {
  auto stool = runged_stool();
  stool.components[1].at = {0.26, 0.26, 0};
  stool.components.pop_back();
  stool.connections.pop_back();
  const auto result = validated(stool);
  CHECK(result.after.sound());
  const Bounds3 leg = box_of(result.program, "leg-0");
  CHECK(leg.high.x() < 0.203);
  CHECK(leg.center().x() == Approx(leg.center().y()).margin(0.001));
  CHECK(box_of(result.program, "leg-3").center().x() == Approx(-leg.center().x()).margin(1e-4));
}

TEST_CASE("A short leg of its own is lengthened to the floor") {
  const auto result = validated(program(
      R"({"name": "top", "label": "top", "box": {"size": [1, 0.6, 0.03]}, "at": [0, 0, 0.7]},
         {"name": "leg", "label": "leg", "box": {"size": [0.05, 0.05, 0.7]}, "at": [0.4, 0.2, 0], "operations": [{"mirror": "x"}]},
         {"name": "left", "label": "front leg", "box": {"size": [0.05, 0.05, 0.7]}, "at": [-0.4, -0.2, 0]},
         {"name": "right", "label": "front leg", "box": {"size": [0.05, 0.05, 0.62]}, "at": [0.4, -0.2, 0.08]})"));
  CHECK(result.after.sound());
  CHECK(result.after.open_connections.empty());
  CHECK(box_of(result.program, "right").low.z() == Approx(0).margin(0.002));
  CHECK(box_of(result.program, "right").high.z() >= 0.699);
}

TEST_CASE("What sticks out below the feet is lifted, not everything else") {
  auto table = turned_table();
  table.components[1].at.z() -= 0.1;  // the column through its foot
  const auto result = validated(table);
  CHECK(result.after.sound());
  CHECK(box_of(result.program, "foot").low.z() == Approx(0).margin(0.001));
}

TEST_CASE("Feet that are too small are widened") {
  const auto result = validated(program(
      R"({"name": "base", "label": "base", "cylinder": {"radius": 0.1, "height": 0.02}},
         {"name": "pole", "label": "pole", "cylinder": {"radius": 0.01, "height": 1.5}, "at": [0, 0, 0.02]},
         {"name": "arm", "label": "arm", "cylinder": {"radius": 0.01, "height": 0.6}, "rotate": [0, 90, 0], "at": [0, 0, 1.5]},
         {"name": "shade", "label": "shade", "cylinder": {"radius": 0.06, "height": 0.08}, "at": [0.55, 0, 1.43]})",
      R"(["base", "floor"], ["pole", "base"], ["arm", "pole"], ["shade", "arm"])"));
  CHECK_FALSE(result.before.stable);
  CHECK(result.after.sound());
}

TEST_CASE("What hangs needs no ground") {
  const auto lamp = program(
      R"({"name": "cord", "label": "cord", "cylinder": {"radius": 0.003, "height": 0.8}, "at": [0, 0, 0.3]},
         {"name": "shade", "label": "shade", "lathe": {"profile": [[0, 0.2], [0.05, 0.2], [0.2, 0], [0.19, 0], [0.05, 0.19], [0, 0.19]], "corners": "all"}, "at": [0, 0, 0.06]})",
      R"(["shade", "cord"])");
  const auto result = validated(lamp, Footing::ceiling);
  CHECK(result.before.pieces == 2);
  CHECK(result.after.sound());
  const auto shelf = program(
      R"({"name": "board", "label": "shelf", "box": {"size": [0.8, 0.2, 0.02]}, "at": [0, 0, 1.2]},
         {"name": "bracket", "label": "bracket", "box": {"size": [0.02, 0.18, 0.15]}, "at": [0.3, 0, 1.05], "operations": [{"mirror": "x"}]})",
      R"(["bracket", "board"], ["board", "wall"])");
  const auto on_wall = validated(shelf, Footing::wall);
  CHECK(on_wall.after.sound());
  CHECK(on_wall.repairs.empty());
}

TEST_CASE("Parts of groups are repaired in the frame of their group") {
  const auto result = validated(program(
      R"({"name": "body", "label": "body", "box": {"size": [0.5, 0.4, 0.5]}},
         {"name": "side", "at": [0.26, 0, 0.2], "rotate": [0, 0, 90],
          "group": {"components": [
            {"name": "panel", "label": "door", "box": {"size": [0.3, 0.02, 0.2]}},
            {"name": "knob", "label": "handle", "ellipsoid": {"size": [0.03, 0.03, 0.03]}, "at": [0.1, -0.1, 0.1]}]},
          "operations": [{"mirror": "x"}]})",
      R"(["side.knob", "side.panel"], ["side.panel", "body"])"));
  CHECK(result.before.pieces == 3);
  CHECK(result.after.sound());
  const Bounds3 knob = box_of(result.program, "side-0.knob"),
                other = box_of(result.program, "side-1.knob");
  CHECK((knob.size() - other.size()).norm() < 1e-6);
  CHECK(knob.center().x() == Approx(-other.center().x()).margin(1e-5));
}

TEST_CASE("Hostile programs are answered in time") {
#ifdef __SANITIZE_ADDRESS__
  constexpr double longest = 200.0;  // seconds: its checks take their time
#else
  constexpr double longest = 20.0;
#endif
  std::vector<shape::Program> programs;
  std::string many, shower, rings;
  for (int k = 0; k < 300; ++k) {
    const std::string place = std::to_string(k % 17 * 0.3) + "," + std::to_string(k % 7 * 0.4) +
                              "," + std::to_string(k % 23 * 0.2);
    shower += std::string(k ? "," : "") + R"({"name": "p)" + std::to_string(k) +
              R"(", "ellipsoid": {"size": [0.1, 0.1, 0.1]}, "at": [)" + place + "]}";
  }
  programs.push_back(program(shower));
  programs.push_back(program(
      R"({"name": "x", "box": {"size": [0.1, 0.1, 0.1]}, "operations": [{"array": {"count": 40, "step": [0.2, 0, 0]}}, {"array": {"count": 10, "step": [0, 0.2, 0]}}]})"));
  // All in one place, each connected to the next in a circle.
  std::string circle;
  for (int k = 0; k < 40; ++k) {
    rings += std::string(k ? "," : "") + R"({"name": "c)" + std::to_string(k) +
             R"(", "label": "leg", "cylinder": {"radius": )" + std::to_string(0.05 + 0.01 * k) +
             R"(, "height": 0.4}})";
    circle += std::string(k ? "," : "") + R"(["c)" + std::to_string(k) + R"(", "c)" +
              std::to_string((k + 1) % 40) + R"("])";
  }
  programs.push_back(program(rings, circle));
  programs.push_back(program(
      R"({"name": "a", "label": "leg", "box": {"size": [0.0002, 0.0002, 20]}, "at": [-20, -20, -20]},
         {"name": "b", "label": "seat", "box": {"size": [20, 20, 0.0002]}, "at": [20, 20, 20]},
         {"name": "c", "label": "leg", "sweep": {"path": [[0, 0, 0], [0, 0, 0.001]], "radius": 0.0004}, "operations": [{"center": "xyz"}, {"ground": true}]})",
      R"(["a", "b"], ["b", "c"], ["c", "a"], ["a", "floor"], ["b", "floor"])"));
  for (const auto& hostile : programs) {
    const auto start = std::chrono::steady_clock::now();
    const auto result = validate(hostile);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    REQUIRE(result);
    CHECK(result->after.pieces <= result->before.pieces);
    CHECK(result->after.open_connections.size() <= result->before.open_connections.size());
    CHECK(took.count() < longest);
    CHECK(shape::evaluate(result->program).ok());
  }
  CHECK_FALSE(validate(shape::Program{}));
  CHECK_FALSE(create::inspect(shape::Program{}));
}

TEST_CASE("Equal programs are repaired alike") {
  auto stool = runged_stool();
  stool.components[0].at = {0.05, 0.02, 0.55};
  CHECK(shape::write_program(validated(stool).program).dump() ==
        shape::write_program(validated(stool).program).dump());
}
