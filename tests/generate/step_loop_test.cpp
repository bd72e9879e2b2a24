#include "catch.h"
#include "roomgen/create/create.h"
#include "roomgen/generate/generate.h"
#include "small_plans.h"
#include "support/contains.h"

using namespace roomgen;
using rooms::item;
using rooms::plan_of;
using rooms::room_with_door;

namespace {

/// Answers by a function and keeps what it was asked.
class Recorder final : public Designer {
 public:
  struct Question {
    std::string id;
    std::vector<std::string> later, refusals;
    std::vector<Bounds2> free_floor;
    std::vector<Object> placed;
  };
  using Answer = std::function<Result<PlaceAdvice>(const PlaceRequest&)>;

  explicit Recorder(Answer answer) : answer_(std::move(answer)) {}

  Result<Plan> plan(const PlanRequest&) override { return Plan(); }
  Result<PlaceAdvice> place(const PlaceRequest& request) override {
    questions.push_back({request.object.id, request.later, request.refusals, request.free_floor,
                         request.scene.objects});
    return answer_(request);
  }

  std::vector<Question> questions;

 private:
  Answer answer_;
};

PlaceAdvice advice(std::vector<Relation> relations = {}) {
  PlaceAdvice result;
  result.relations = std::move(relations);
  return result;
}

/// Keeps what it was asked for, and draws nothing.
class ViewKeeper final : public Renderer {
 public:
  Result<Image> render(const Scene&, const ModelTable&, const View& view) override {
    views.push_back(view);
    return Image(1, 1);
  }
  Result<Image> sheet(const ContactSheet&, const ModelTable&) override { return Image(1, 1); }
  Result<Layers> layers(const Scene&, const ModelTable&, const Shot&) override { return Layers(); }
  Result<Visibility> visibility(const Scene&, const ModelTable&, const Camera&, std::size_t,
                                std::size_t) override {
    return Visibility();
  }

  std::vector<View> views;
};

Generation furnish(const Plan& plan, Recorder& designer, BuildOptions options = {}) {
  const auto library = create::make_created_library();
  auto generation = generate(plan, designer, *library, KindTable::built_in(), options);
  REQUIRE(generation);
  return *std::move(generation);
}

std::vector<std::string> order(const Recorder& designer) {
  std::vector<std::string> ids;
  for (const auto& question : designer.questions)
    if (ids.empty() || ids.back() != question.id) ids.push_back(question.id);
  return ids;
}

}  // namespace

TEST_CASE("The designer may choose what comes next, among what can stand already") {
  const Plan plan = plan_of(
      {item("bookshelf"), item("desk"), item("table lamp", Mount::surface), item("wardrobe")},
      room_with_door(5, 4));
  Recorder designer([](const PlaceRequest& request) {
    PlaceAdvice answer = advice();
    if (request.object.id == "bookshelf-0") answer.next = "wardrobe-0";
    if (request.object.id == "wardrobe-0") answer.next = "no such thing";
    return answer;
  });
  const auto generation = furnish(plan, designer);
  CHECK(order(designer) ==
        std::vector<std::string>{"bookshelf-0", "wardrobe-0", "desk-0", "table lamp-0"});
  // What stands on others waits for all that might carry it.
  CHECK(designer.questions.front().later == std::vector<std::string>{"desk-0", "wardrobe-0"});
  for (const auto& question : designer.questions)
    if (question.id == "desk-0") CHECK(question.later == std::vector<std::string>{"table lamp-0"});
  // The scene lists things in the plan's order all the same.
  REQUIRE(generation.scene.objects.size() == 4);
  CHECK(generation.scene.objects[1].id == "desk-0");
  CHECK_FALSE(generation.scene.objects[2].on.empty());
}

TEST_CASE("A refused answer comes back with what was in the way and the floor that is left") {
  // A pool table longer than the room.
  Plan plan = plan_of({item("wardrobe"), item("pool table")}, room_with_door(2.2, 2.2));
  plan.items[0].size = Vec3(1.2, 0.6, 2.0);
  plan.items[1].size = Vec3(2.4, 1.3, 0.8);
  Recorder designer([](const PlaceRequest& request) {
    PlaceAdvice answer = advice();
    if (request.object.id == "pool table-0") answer.location = Vec2(1.1, 1.1);
    return answer;
  });
  const auto generation = furnish(plan, designer);
  REQUIRE(generation.scene.objects.size() == 1);
  REQUIRE(generation.scene.unplaced.size() == 1);
  CHECK(generation.scene.unplaced[0].id == "pool table-0");
  CHECK(contains_text(generation.scene.unplaced[0].reason, "in the way at the suggested place"));
  CHECK(contains_text(generation.scene.unplaced[0].reason, "wardrobe-0"));
  bool told = false;
  for (const auto& question : designer.questions) {
    CHECK(question.free_floor.empty() == question.refusals.empty());
    for (const auto& part : question.free_floor) {
      told = true;
      // As things stood then: a repair may have moved them since.
      for (const auto& object : question.placed)
        CHECK_FALSE(overlaps(Footprint(0.5 * (part.low + part.high), part.size(), 0.0),
                             footprint(object)));
    }
  }
  CHECK(told);
}

TEST_CASE(
    "Pictures show where a refused answer would have been, walls for what hangs, the carrier's "
    "top") {
  Plan plan = plan_of({item("wardrobe"), item("pool table"), item("mirror", Mount::wall),
                       item("desk"), item("table lamp", Mount::surface)},
                      room_with_door(4, 4));
  plan.items[0].size = Vec3(1.2, 0.6, 2.0);
  plan.items[1].size = Vec3(4.5, 1.3, 0.8);  // longer than the room
  plan.items[4].on = "desk";
  ViewKeeper pictures;
  std::map<std::string, std::vector<View>> shown;  // the last time
  Vec2 wardrobe = Vec2::Zero();
  Recorder designer([&](const PlaceRequest& request) {
    pictures.views.clear();
    REQUIRE(request.marks());
    shown[request.object.id] = pictures.views;
    PlaceAdvice answer = advice();
    if (request.object.id != "pool table-0") return answer;
    wardrobe = find_object(request.scene, "wardrobe-0")->position.head<2>();
    answer.location = wardrobe;
    answer.yaw = 0.5 * pi;
    return answer;
  });
  BuildOptions options;
  options.renderer = &pictures;
  furnish(plan, designer, options);
  REQUIRE(shown["wardrobe-0"].size() == 1);
  CHECK(shown["wardrobe-0"][0].refused.empty());
  CHECK(shown["wardrobe-0"][0].asked == Mount::floor);
  const auto& again = shown["pool table-0"];
  REQUIRE(again.size() == 1);
  REQUIRE(again[0].refused.size() == 1);
  CHECK(again[0].refused[0].position.head<2>() == wardrobe);
  CHECK(again[0].refused[0].yaw == 0.5 * pi);
  CHECK(again[0].in_the_way == std::vector<std::string>{"wardrobe-0"});
  REQUIRE(shown["mirror-0"].size() == 2);
  CHECK(shown["mirror-0"][0].asked == Mount::wall);
  CHECK(shown["mirror-0"][1].kind == View::Kind::elevation);
  REQUIRE(shown["table lamp-0"].size() == 2);
  CHECK(shown["table lamp-0"][1].part);
}

TEST_CASE("One object that fails costs no other its place") {
  const Plan plan = plan_of({item("bookshelf"), item("no such kind of thing"), item("desk")},
                            room_with_door(5, 4));
  Recorder designer([](const PlaceRequest&) { return advice(); });
  const auto generation = furnish(plan, designer);
  CHECK(generation.scene.objects.size() == 2);
  REQUIRE(generation.scene.unplaced.size() == 1);
  CHECK_FALSE(generation.scene.incomplete);
  CHECK(generation.trace.size() == 3);
}

TEST_CASE("A designer that may ask no more ends the room with what is placed") {
  const Plan plan =
      plan_of({item("bookshelf"), item("desk"), item("wardrobe")}, room_with_door(5, 4));
  Recorder designer([](const PlaceRequest& request) -> Result<PlaceAdvice> {
    if (request.object.id == "desk-0") return Error{Error::Kind::limit, "no money left"};
    return advice();
  });
  const auto generation = furnish(plan, designer);
  CHECK(generation.scene.incomplete);
  CHECK(generation.stopped == "no money left");
  REQUIRE(generation.scene.objects.size() == 1);
  CHECK(generation.scene.objects[0].id == "bookshelf-0");
  CHECK(generation.scene.unplaced.size() == 2);
}

TEST_CASE("How closely suggestions were followed is counted") {
  const Plan plan = plan_of({item("desk"), item("bookshelf")}, room_with_door(6, 6));
  Recorder designer([](const PlaceRequest& request) {
    PlaceAdvice answer = advice();
    answer.location = Vec2(3, 3);
    if (request.object.id == "bookshelf-0") {
      answer.relations = {{RelationKind::edge, ""}};
      answer.location = Vec2(5.8, 5.8), answer.yaw = 0.0;
    }
    return answer;
  });
  const auto generation = furnish(plan, designer);
  REQUIRE(generation.scene.objects.size() == 2);
  int half = 0, one = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec2 wanted = i == 0 ? Vec2(3, 3) : Vec2(5.8, 5.8);
    const double distance = (generation.scene.objects[i].position.head<2>() - wanted).norm();
    half += distance <= 0.5, one += distance <= 1.0;
  }
  CHECK(generation.suggestions.located == 2);
  CHECK(generation.suggestions.within[1] == half);
  CHECK(generation.suggestions.within[2] == one);
  CHECK(generation.suggestions.faced == 1);
  CHECK(one >= 1);
}
