#include <cmath>

#include "catch.h"
#include "roomgen/base/text.h"
#include "roomgen/create/create.h"
#include "roomgen/generate/generate.h"
#include "small_plans.h"
#include "support/contains.h"

using namespace roomgen;
using rooms::item;
using rooms::plan_of;
using rooms::room_with_door;

namespace {

/// A designer that says what a function says, as a model would.
class Speaker final : public Designer {
 public:
  using Answer = std::function<PlaceAdvice(const PlaceRequest&)>;
  explicit Speaker(Answer answer) : answer_(std::move(answer)) {}

  Result<Plan> plan(const PlanRequest&) override { return Plan(); }
  Result<PlaceAdvice> place(const PlaceRequest& request) override {
    asked.push_back(request.object.id);
    objections.push_back(request.objections);
    PlaceAdvice advice = answer_(request);
    advice.consultation.calls = 1;
    return advice;
  }

  std::vector<std::string> asked;
  std::vector<std::vector<std::string>> objections;

 private:
  Answer answer_;
};

PlaceAdvice said(const std::string& constraints, const Vec2& location, double degrees_) {
  PlaceAdvice advice;
  advice.relations = *parse_relations(constraints);
  advice.location = location;
  advice.yaw = radians(degrees_);
  return advice;
}

/// Has things of their usual size alone.
class UsualSizes final : public AssetLibrary {
 public:
  Result<std::vector<AssetMatch>> search(const AssetQuery& query) const override {
    AssetQuery usual = query;
    usual.size = KindTable::built_in().get(query.category).size;
    return made_->search(usual);
  }
  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override {
    return made_->load(ref);
  }

 private:
  std::unique_ptr<AssetLibrary> made_ = create::make_created_library();
};

Generation furnished(const Plan& plan, Speaker& designer, BuildOptions options = {},
                     const AssetLibrary& library = *create::make_created_library()) {
  auto generation = generate(plan, designer, library, KindTable::built_in(), options);
  REQUIRE(generation);
  return *std::move(generation);
}

const Object& object(const Generation& generation, const std::string& id) {
  for (const auto& one : generation.scene.objects)
    if (one.id == id) return one;
  FAIL(id + " is not there");
  return generation.scene.objects.front();
}

double off(const Object& placed, const Vec2& location) {
  return (placed.position.head<2>() - location).norm();
}

// As in questions.
std::string design_size(const Object& one) {
  return format_number(one.size.x(), 2) + " x " + format_number(one.size.y(), 2);
}

double turned(const Object& placed, double degrees_) {
  return degrees(std::abs(wrap_angle(placed.yaw - radians(degrees_))));
}

}  // namespace

TEST_CASE("What is suggested is taken, off the grid and turned as it was said") {
  Speaker designer([](const PlaceRequest&) { return said("middle", {2.137, 2.271}, 57); });
  const auto room = furnished(plan_of({item("armchair")}, room_with_door(4.6, 4.2)), designer);
  const Object& chair = object(room, "armchair-0");
  CHECK(off(chair, {2.137, 2.271}) < 0.01);
  CHECK(turned(chair, 57) < 0.1);
  CHECK(designer.asked.size() == 1);
}

TEST_CASE("A small thing stands off the middle of what carries it where that is said") {
  PlanItem lamp = item("vase", Mount::surface);
  lamp.on = "table-0";
  Speaker designer([](const PlaceRequest& request) {
    if (request.object.id == "table-0") return said("middle", {2.3, 2.1}, 0);
    return said("on, table-0", {2.62, 2.24}, 0);
  });
  const auto room =
      furnished(plan_of({item("table"), lamp}, room_with_door(4.6, 4.2)), designer);
  CHECK(off(object(room, "vase-0"), {2.62, 2.24}) < 0.03);
}

TEST_CASE("What is said to stand nearly at a wall stands flush with it") {
  Speaker designer([](const PlaceRequest& request) {
    return said("edge", {2.0, 4.2 - 0.04 - 0.5 * request.object.size.y()}, 2);
  });
  const auto room = furnished(plan_of({item("sofa")}, room_with_door(4.6, 4.2)), designer);
  const Object& sofa = object(room, "sofa-0");
  CHECK(4.2 - sofa.position.y() - 0.5 * sofa.size.y() < 0.01);
  CHECK(turned(sofa, 0) < 0.1);
  CHECK(std::abs(sofa.position.x() - 2.0) < 0.01);
}

TEST_CASE("What is said squarely and near enough to a wall stands just there") {
  for (const std::string constraints : {"edge", "next to, wall-2"}) {
    Speaker designer([&](const PlaceRequest& request) {
      return said(constraints, {2.0, 4.2 - 0.03 - 0.5 * request.object.size.y()}, 0);
    });
    const auto room = furnished(plan_of({item("sofa")}, room_with_door(4.6, 4.2)), designer);
    const Object& sofa = object(room, "sofa-0");
    CHECK(4.2 - sofa.position.y() - 0.5 * sofa.size.y() == Approx(0.03).margin(1e-3));
  }
}

TEST_CASE("What is said decides how a thing is put up, not what its kind is used to") {
  PlanItem boiler = item("water heater", Mount::wall), stool = item("stool");
  boiler.size = Vec3(0.45, 0.45, 0.9);
  stool.size = Vec3(0.4, 0.4, 0.5);
  Speaker designer([](const PlaceRequest& request) {
    if (request.object.id == "water heater-0") return said("middle", {2.3, 2.6}, 0);
    PlaceAdvice advice = said("", {1.5, 2.0}, 0);
    advice.bottom = 1.6;
    return advice;
  });
  const auto room = furnished(plan_of({boiler, stool}, room_with_door(4.6, 4.2)), designer);
  const Object &standing = object(room, "water heater-0"), &hung = object(room, "stool-0");
  CHECK(standing.mount == Mount::floor);
  CHECK(standing.position.z() < 1e-6);
  CHECK(off(standing, {2.3, 2.6}) < 0.01);
  CHECK(hung.mount == Mount::ceiling);
  CHECK(bottom(hung) == Approx(1.6));
  CHECK(top(hung) == Approx(room.scene.room.height));
  // At its own height, by a wire.
  CHECK(hung.size.z() * (1.0 - hung.asset.wires) == Approx(0.5).margin(0.06));
}

TEST_CASE("What hangs under a beam hangs from it") {
  PlanItem beam = item("cable tray", Mount::ceiling), stool = item("stool");
  beam.size = Vec3(3.0, 0.2, 0.2);
  stool.size = Vec3(0.3, 0.3, 0.4);
  Speaker designer([](const PlaceRequest& request) {
    if (request.object.id == "cable tray-0") return said("", {2.3, 2.0}, 0);
    PlaceAdvice advice = said("hang from, cable tray-0", {1.7, 2.0}, 0);
    advice.bottom = 1.7;
    return advice;
  });
  const auto room = furnished(plan_of({beam, stool}, room_with_door(4.6, 4.2)), designer);
  CHECK(off(object(room, "stool-0"), {1.7, 2.0}) < 0.01);
  CHECK(bottom(object(room, "stool-0")) == Approx(1.7));
  CHECK(top(object(room, "stool-0")) == Approx(bottom(object(room, "cable tray-0"))));
}

TEST_CASE("No constraint of a later thing moves what a designer placed") {
  Speaker designer([](const PlaceRequest& request) {
    if (request.object.id == "sofa-0") return said("edge", {2.0, 3.7}, 0);
    return said("behind, sofa-0", {3.9, 3.2}, 0);  // where the wall is
  });
  const auto plan = plan_of({item("sofa"), item("stool")}, room_with_door(4.6, 4.2));
  const auto kept = furnished(plan, designer);
  CHECK(off(object(kept, "sofa-0"), {2.0, 3.7}) < 0.1);
  CHECK(kept.moved.empty());
  CHECK(kept.suggestions.within[0] == kept.suggestions.placed_within[0]);
  bool told = false;
  for (const auto& note : kept.notes) told |= contains_text(note, "\"behind, sofa-0\" does not hold");
  CHECK(told);
}

TEST_CASE("What could not be followed is asked about once more, and the better answer stays") {
  int answers = 0;
  Speaker designer([&](const PlaceRequest& request) {
    if (request.object.id == "sofa-0") return said("edge", {2.0, 3.7}, 0);
    if (answers++ == 0) return said("behind, sofa-0", {3.9, 4.15}, 0);  // too near to the wall
    return said("near, sofa-0", {3.9, 3.2}, 0);
  });
  const auto room =
      furnished(plan_of({item("sofa"), item("stool")}, room_with_door(4.6, 4.2)), designer);
  REQUIRE(designer.asked.size() == 3);
  REQUIRE(designer.objections[2].size() == 1);
  CHECK(contains_text(designer.objections[2][0], "behind, sofa-0"));
  CHECK(off(object(room, "stool-0"), {3.9, 3.2}) < 0.1);
  CHECK(room.held == room.constraints);
  CHECK(room.notes.empty());
}

TEST_CASE("A group that is placed anew goes whole to where it is said then") {
  int answers = 0;
  Speaker designer([&](const PlaceRequest&) {
    return answers++ == 0 ? said("behind, wall-0", {0.1, 2.0}, 0) : said("", {3.2, 2.6}, 0);
  });
  auto plan = rooms::desk_and_stool({}, "[0.8, 0]");
  plan.groups.front().location.reset(), plan.groups.front().facing.reset();
  const auto room = furnished(plan, designer);
  CHECK(answers == 2);
  CHECK(off(object(room, "desk-0"), {3.2, 2.6}) < 0.02);
  CHECK(off(object(room, "stool-0"), {4.0, 2.6}) < 0.02);
}

TEST_CASE("Who is asked again learns what was in the way") {
  Speaker designer([](const PlaceRequest& request) {
    return request.object.id == "sofa-0" ? said("", {2.3, 2.0}, 0) : said("edge", {2.3, 2.1}, 0);
  });
  furnished(plan_of({item("sofa"), item("desk")}, room_with_door(4.6, 4.2)), designer);
  const auto told = std::find_if(designer.objections.begin(), designer.objections.end(),
                                 [](const auto& some) { return !some.empty(); });
  REQUIRE(told != designer.objections.end());
  CHECK(contains_text(told->back(), "in the way at the suggested place: sofa-0"));
}

TEST_CASE("Without improvement and repair nothing that stands moves") {
  Speaker designer([](const PlaceRequest& request) {
    if (request.object.id == "sofa-0") return said("edge", {2.0, 3.7}, 0);
    return said("behind, sofa-0", {3.9, 3.2}, 0);
  });
  BuildOptions options;
  options.improvement = Improvement::off;
  options.repair = false;
  const auto room =
      furnished(plan_of({item("sofa"), item("stool", Mount::floor, 3)}, room_with_door(4.6, 4.2)),
                designer, options);
  CHECK(room.moved.empty());
  for (const auto& step : room.trace) CHECK(step.moved.empty());
}

TEST_CASE("A rug lies where a designer put it, and what must change is told in the next question") {
  Plan plan = plan_of({item("rug"), item("table"), item("vase", Mount::surface)}, room_with_door(5, 5));
  plan.items[0].size = Vec3(2.0, 1.4, 0.02);
  plan.items[2].on = "table-0";
  for (const double across : {0.0, 0.9}) {  // beyond its edge
    std::vector<std::string> told;
    Speaker designer([&](const PlaceRequest& request) {
      if (request.elsewhere) told = request.elsewhere();
      if (request.object.id == "rug-0") return said("middle", {2.6, 3.0}, 0);
      if (request.object.id == "vase-0") return said("on, table-0", {2.6 + across, 3.0}, 0);
      return said("middle", {2.6 + across, 3.0}, 0);
    });
    plan.items[1].size = Vec3(0.9, 0.6, 0.5);
    const auto room = furnished(plan, designer);
    const Object& rug = object(room, "rug-0");
    const bool is_as_said = off(rug, {2.6, 3.0}) < 0.01 && (rug.size - Vec3(2.0, 1.4, 0.02)).norm() < 0.01;
    CHECK(is_as_said == (across == 0.0));
    CHECK(told.empty() == is_as_said);
    bool is_noted = false;
    for (const auto& note : room.notes) is_noted |= contains_text(note, "so that nothing stands on its edge");
    CHECK(is_noted == !is_as_said);
    if (!is_as_said) CHECK(contains_text(told.front(), design_size(rug)));
    CHECK(room.suggestions.within[0] == (is_as_said || off(rug, {2.6, 3.0}) < 0.25 ? 3 : 2));
  }
}

TEST_CASE("A size that came out otherwise than a designer asked is told in the next question and in the end") {
  const std::vector<std::string> kinds = {"sofa", "armchair", "coffee table", "bookshelf", "stool"};
  int others = 0;
  for (const double factor : {0.7, 1.0, 1.4}) {
    std::vector<PlanItem> items;
    for (const auto& kind : kinds) {
      items.push_back(item(kind));
      items.back().size = factor * KindTable::built_in().get(kind).size;
    }
    const Plan plan = plan_of(items, room_with_door(7, 7));
    std::vector<std::string> told;
    Speaker designer([&](const PlaceRequest& request) {
      for (const auto& one : request.elsewhere()) told.push_back(one);
      return said("edge", {3.0, 3.0}, 0);
    });
    const auto room = furnished(plan, designer, {}, UsualSizes());
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      const Object* placed = find_object(room.scene, kinds[i] + "-0");
      if (!placed) continue;
      const Vec3 off = placed->size.cwiseQuotient(*items[i].size);
      const bool is_other = off.maxCoeff() > 1.05 || off.minCoeff() < 1 / 1.05;
      others += is_other;
      const auto says = [&](const std::vector<std::string>& texts) {
        return std::count_if(texts.begin(), texts.end(), [&](const std::string& text) {
          return contains_text(text, kinds[i] + "-0 is ") && contains_text(text, " m, not ");
        });
      };
      INFO(kinds[i] << " " << factor);
      CHECK(says(room.notes) == (is_other ? 1 : 0));
      if (i + 1 < kinds.size()) CHECK((says(told) > 0) == is_other);
    }
  }
  CHECK(others > 0);
}

namespace {

bool says(const std::vector<std::string>& texts, const std::string& part) {
  return std::any_of(texts.begin(), texts.end(),
                     [&](const std::string& text) { return contains_text(text, part); });
}

}  // namespace

TEST_CASE("What the said place itself breaks is told in the next question, not asked again") {
  for (const double away : {0.0, 1.55}) {  // at the said place; where a wall is, so that it stands elsewhere
    std::vector<std::string> told;
    Speaker designer([&](const PlaceRequest& request) {
      for (const auto& one : request.elsewhere()) told.push_back(one);
      if (request.object.id == "sofa-0") return said("edge", {2.0, 3.7}, 0);
      if (request.object.id == "table-0") return said("middle", {1.0, 1.8}, 0);
      return said("next to, sofa-0", {3.0 + away, 1.0}, 0);
    });
    const auto room = furnished(
        plan_of({item("sofa"), item("stool"), item("table")}, room_with_door(4.6, 4.2)), designer);
    const auto asked = std::count(designer.asked.begin(), designer.asked.end(), "stool-0");
    const bool is_there = off(object(room, "stool-0"), {3.0 + away, 1.0}) < 0.05;
    CHECK(asked == (is_there ? 1 : 2));
    CHECK(is_there == (away == 0.0));
    const bool is_told = says(told, "\"next to, sofa-0\" does not hold");
    if (is_there) CHECK(is_told);
  }
}

TEST_CASE("Moves hold whichever of two answers does, and make way for each other") {
  std::vector<std::string> told;
  const Vec2 first(1.0, 2.2), second(2.6, 2.2);
  Speaker designer([&](const PlaceRequest& request) {
    for (const auto& one : request.elsewhere()) told.push_back(one);
    const std::string& id = request.object.id;
    if (id == "stool-0") return said("", first, 0);
    if (id == "stool-1") return said("", second, 0);
    if (id == "stool-2") return said("", {3.8, 3.6}, 0);
    if (request.objections.empty()) {
      PlaceAdvice advice = said("", {3.8, 2.2}, 0);
      advice.moves = {{"stool-9", {1.0, 1.0}, {}}};
      return advice;
    }
    PlaceAdvice advice = said("far, stool-2 | next to, stool-2", {1.0, 3.6}, 180);  // followed less than before
    advice.moves = {{"stool-0", second, {}}, {"stool-1", {2.6, 3.2}, {}}, {"stool-8", {1.0, 1.0}, {}}};
    return advice;
  });
  const auto room = furnished(plan_of({item("stool", Mount::floor, 3), item("armchair"), item("plant")},
                                      room_with_door(4.6, 4.2)),
                              designer);
  CHECK(off(object(room, "armchair-0"), {3.8, 2.2}) < 0.05);
  CHECK(off(object(room, "stool-0"), second) < 0.05);
  CHECK(off(object(room, "stool-1"), {2.6, 3.2}) < 0.05);
  CHECK(says(told, "stool-8 does not stand"));
  CHECK(says(told, "your second answer for armchair-0 was not taken"));
}

TEST_CASE("A second answer may leave a thing out") {
  Speaker designer([&](const PlaceRequest& request) {
    if (request.object.id == "sofa-0") return said("edge", {2.0, 3.7}, 0);
    PlaceAdvice advice = said("behind, sofa-0", {2.0, 4.1}, 0);
    if (!request.objections.empty()) advice.leave_out = "no room behind the sofa";
    return advice;
  });
  const auto room =
      furnished(plan_of({item("sofa"), item("stool")}, room_with_door(4.6, 4.2)), designer);
  CHECK_FALSE(find_object(room.scene, "stool-0"));
  REQUIRE(room.scene.unplaced.size() == 1);
  CHECK(contains_text(room.scene.unplaced[0].reason, "no room behind the sofa"));
}

TEST_CASE("What is moved on a top rests there at its height, and on another top at that one's") {
  PlanItem table = item("table"), low = item("coffee table"), vase = item("vase", Mount::surface);
  vase.on = "table-0";
  Vec2 to(2.6, 3.0);
  for (const bool elsewhere : {false, true}) {
    if (elsewhere) to = {1.0, 1.6};
    Speaker designer([&](const PlaceRequest& request) {
      const std::string& id = request.object.id;
      if (id == "table-0") return said("", {2.3, 3.0}, 0);
      if (id == "coffee table-0") return said("", {1.0, 1.6}, 0);
      if (id == "vase-0") return said("on, table-0", {2.1, 3.0}, 0);
      PlaceAdvice advice = said("", {4.0, 1.0}, 0);
      advice.moves = {{"vase-0", to, {}}};
      return advice;
    });
    const auto room =
        furnished(plan_of({table, low, vase, item("picture", Mount::wall)}, room_with_door(4.6, 4.2)), designer);
    const Object& moved = object(room, "vase-0");
    const Object& below = object(room, elsewhere ? "coffee table-0" : "table-0");
    CHECK(off(moved, to) < 0.03);
    CHECK(moved.on == below.id);
    CHECK(bottom(moved) == Approx(top(below)).margin(0.01));
  }
}

TEST_CASE("The size that an answer gives holds for what is built") {
  PlanItem shelf = item("wall shelf", Mount::wall);
  shelf.size = Vec3(0.9, 0.22, 0.05);
  const auto library = create::make_created_library();
  AssetQuery query;
  query.category = shelf.category, query.size = *shelf.size, query.mount = Mount::wall;
  query.sized = true;
  const auto matches = library->search(query);
  REQUIRE(matches);
  REQUIRE_FALSE(matches->empty());
  shelf.asset = asset_key(matches->front().asset.ref);
  Speaker designer([](const PlaceRequest&) {
    PlaceAdvice advice = said("edge", {2.0, 4.1}, 0);
    advice.size = Vec3(0.75, 0.22, 0.05);
    return advice;
  });
  const auto room = furnished(plan_of({shelf}, room_with_door(4.6, 4.2)), designer, {}, *library);
  CHECK(object(room, "wall shelf-0").size.x() == Approx(0.75).margin(0.01));
}

TEST_CASE("What went to another carrier is told in the next question, with the reason") {
  PlanItem table = item("table"), low = item("stool"), lamp = item("table lamp", Mount::surface);
  table.part = "table", low.part = "stand", lamp.part = "lamp";
  low.size = Vec3(0.3, 0.3, 0.5), lamp.size = Vec3(0.25, 0.25, 0.4);
  lamp.quantity = 0;
  for (PlanItem* one : {&table, &low, &lamp}) one->group = "lamps", one->asked = true;
  Plan plan = plan_of({table, low, lamp}, room_with_door(4.6, 4.2));
  PlanGroup group;
  group.id = "lamps";
  group.definition = R"({"parts": [{"part": "table", "kind": "table"},
      {"part": "stand", "kind": "stool", "beside": "table", "side": "left", "gap": 0.3},
      {"part": "lamp", "kind": "table lamp", "on": "stand", "repeat": {"columns": 4, "across": 0.05}}]})";
  group.asked = true;
  plan.groups = {group};
  std::vector<std::string> told;
  Speaker designer([&](const PlaceRequest& request) {
    for (const auto& one : request.elsewhere()) told.push_back(one);
    if (request.object.id == "table-0") return said("", {2.3, 2.6}, 0);
    return said("on, table-0", {2.3, 2.6}, 0);
  });
  const auto room = furnished(plan, designer);
  for (const auto& one : told) UNSCOPED_INFO(one);
  CHECK(says(told, " stands on table-0, not on stool-0: no place for table lamp"));
}
