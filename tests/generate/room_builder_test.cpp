#include "roomgen/generate/room_builder.h"

#include <condition_variable>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "catch.h"
#include "roomgen/base/json.h"
#include "roomgen/create/create.h"
#include "roomgen/design/designer.h"
#include "roomgen/generate/generate.h"
#include "small_plans.h"
#include "support/contains.h"
#include "support/error_of.h"
#include "support/solved.h"

using namespace roomgen;

namespace {

Plan bedroom() {
  Plan plan = rooms::plan_of({rooms::item("bed"), rooms::item("nightstand", Mount::floor, 2),
                              rooms::item("desk"), rooms::item("chair"),
                              rooms::item("table lamp", Mount::surface)},
                             rooms::room_with_door(4.5, 4));
  plan.items[1].relations = {{RelationKind::near, "bed-0"}};
  return plan;
}

/// A builder with all that it works with.
struct Site {
  explicit Site(Plan plan, BuildOptions options = {})
      : designer(make_rule_designer()),
        library(create::make_created_library()),
        builder(*RoomBuilder::begin(std::move(plan), *designer, *library, KindTable::built_in(),
                                    std::move(options))) {}

  std::unique_ptr<Designer> designer;
  std::unique_ptr<AssetLibrary> library;
  RoomBuilder builder;
};

/// All of it as text: scene and trace.
std::string text_of(const Generation& generation) {
  std::string text = dump_json(to_json(generation.scene));
  for (const auto& step : generation.trace) text += to_json(step).dump() + "\n";
  return text;
}

void step_through(RoomBuilder& builder) {
  while (builder.next()) REQUIRE(builder.step());
  REQUIRE(builder.improve());
}

std::string made_at_one_go(const Plan& plan) {
  const auto designer = make_rule_designer();
  const auto library = create::make_created_library();
  const auto made = generate(plan, *designer, *library, KindTable::built_in());
  REQUIRE(made);
  return text_of(*made);
}

/// Reads meshes at once, until it is held: then a reader stays in the middle of its mesh until it is let go.
class HeldLibrary final : public AssetLibrary {
 public:
  Result<std::vector<AssetMatch>> search(const AssetQuery& query) const override {
    return inner_->search(query);
  }
  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override {
    {
      std::unique_lock lock(mutex_);
      ++begun_;
      changed_.notify_all();
      changed_.wait(lock, [this] { return !held_; });
      ++ended_;
    }
    return inner_->load(ref);
  }

  void hold() {
    const std::lock_guard lock(mutex_);
    held_ = true;
    begun_ = ended_ = 0;
  }
  void let_go() {
    const std::lock_guard lock(mutex_);
    held_ = false;
    changed_.notify_all();
  }
  void wait_for_reader() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return begun_ > 0; });
  }
  /// Meshes since it was held.
  int begun() const { return number(begun_); }
  int ended() const { return number(ended_); }

 private:
  int number(const int& count) const {
    const std::lock_guard lock(mutex_);
    return count;
  }

  std::unique_ptr<AssetLibrary> inner_ = create::make_created_library();
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  mutable int begun_ = 0, ended_ = 0;
  bool held_ = false;
};

}  // namespace

TEST_CASE("Step by step a room becomes what is made at one go") {
  Site site(bedroom());
  step_through(site.builder);
  CHECK(text_of(site.builder.generation()) == made_at_one_go(bedroom()));
}

TEST_CASE("What is planned beyond what a room holds is left out with the reason, added things first") {
  Plan plan = rooms::plan_of({rooms::item("chair", Mount::floor, 200), rooms::item("stool", Mount::floor, 150)},
                             rooms::room_with_door(30, 30));
  plan.items[0].asked = false;
  plan.items[1].asked = true;
  const Site site(std::move(plan));
  const Generation before = site.builder.generation();
  REQUIRE(before.scene.unplaced.size() == 350);
  std::size_t beyond = 0;
  for (const auto& missing : before.scene.unplaced) {
    if (!contains_text(missing.reason, "at most 300")) continue;
    ++beyond;
    CHECK(missing.category == "chair");
  }
  CHECK(beyond == 50);
}

TEST_CASE("Any number of steps is taken back, and the same steps again give the same") {
  Site site(bedroom());
  RoomBuilder& builder = site.builder;
  const std::string empty = text_of(builder.generation());
  step_through(builder);
  const std::string whole = text_of(builder.generation());
  CHECK(builder.undo(3) == 3);  // the improvement and the last two objects
  CHECK(builder.left().size() == 2);
  CHECK(builder.scene().objects.size() == 4);
  step_through(builder);
  CHECK(text_of(builder.generation()) == whole);
  CHECK(builder.undo(100) == 7);
  CHECK(text_of(builder.generation()) == empty);
  CHECK(builder.undo() == 0);
  step_through(builder);
  CHECK(text_of(builder.generation()) == whole);
}

TEST_CASE("Proposals are valid places with their scores, and change nothing") {
  Site site(bedroom());
  RoomBuilder& builder = site.builder;
  const std::string before = text_of(builder.generation());
  const auto proposal = builder.propose("bed-0", 4);
  REQUIRE(proposal);
  CHECK(text_of(builder.generation()) == before);
  REQUIRE(proposal->places.size() == 4);
  for (std::size_t i = 0; i < proposal->places.size(); ++i) {
    const auto placed = builder.place(*proposal, i);
    REQUIRE(placed);
    CHECK(placed->attempts.front().chosen->lost == proposal->places[i].terms.lost);
    CHECK(violations(builder.scene()).empty());
    CHECK(builder.scene().objects.front().position == proposal->places[i].object.position);
    for (std::size_t j = 0; j < i; ++j)
      CHECK(proposal->places[j].object.position != proposal->places[i].object.position);
    CHECK(builder.undo() == 1);
  }
  REQUIRE(builder.step());
  CHECK(builder.scene().objects.front().position == proposal->places[0].object.position);
  CHECK_FALSE(builder.place(*proposal));  // it stands already
  CHECK(builder.propose("nightstand-0")->places.size() >= 1);
  CHECK(error_of(builder.propose("throne-0")) == "\"throne-0\" is no object of the plan");
}

TEST_CASE("A proposal whose place is taken meanwhile is refused with what is there") {
  Site site(bedroom());
  RoomBuilder& builder = site.builder;
  const auto bed = builder.propose("bed-0", 1);
  REQUIRE(bed);
  const Object& object = bed->places.front().object;
  REQUIRE(builder.place("desk-0", WantedPose{object.position.head<2>(), object.yaw}));
  CHECK(contains_text(error_of(builder.place(*bed)), "desk-0 is in the way"));
}

TEST_CASE("A thing stands exactly where a host wants it, and stays there") {
  Site site(bedroom());
  RoomBuilder& builder = site.builder;
  REQUIRE(builder.place("desk-0", WantedPose{{2.0, 2.5}, pi / 2}));
  step_through(builder);
  const auto made = builder.generation();
  for (const auto& object : made.scene.objects) {
    if (object.id != "desk-0") continue;
    CHECK(object.position == Vec3(2.0, 2.5, 0.0));
    CHECK(object.yaw == Approx(pi / 2));
    CHECK(object.locked);
  }
  CHECK(violations(made.scene).empty());
  CHECK_FALSE(made.scene.incomplete);
}

TEST_CASE("What rests on others finds its height by itself") {
  Site site(bedroom());
  RoomBuilder& builder = site.builder;
  CHECK(contains_text(error_of(builder.place("table lamp-0", WantedPose{{2.0, 2.5}})),
                      "nothing carries it"));
  REQUIRE(builder.place("desk-0", WantedPose{{2.0, 2.5}}));
  REQUIRE(builder.place("table lamp-0", WantedPose{{2.0, 2.5}}));
  const auto scene = builder.scene();
  CHECK(scene.objects[1].on == "desk-0");
  CHECK(scene.objects[1].position.z() == Approx(top(scene.objects[0])).margin(0.05));
}

TEST_CASE("A pose that cannot be is refused with the reason and changes nothing") {
  Site site(bedroom());
  RoomBuilder& builder = site.builder;
  REQUIRE(builder.place("desk-0", WantedPose{{2.0, 2.5}}));
  const std::string before = text_of(builder.generation());
  CHECK(contains_text(error_of(builder.place("bed-0", WantedPose{{0.0, 2.5}})), "leave the room"));
  CHECK(contains_text(error_of(builder.place("bed-0", WantedPose{{2.0, 2.5}})), "desk-0"));
  CHECK(contains_text(error_of(builder.place("desk-0", WantedPose{{1.0, 2.5}})), "stands already"));
  CHECK(text_of(builder.generation()) == before);
}

TEST_CASE("Constraints of a host lead to a place as those of a designer do") {
  Site site(bedroom());
  RoomBuilder& builder = site.builder;
  REQUIRE(builder.step());
  PlaceAdvice wish;
  wish.relations = {{RelationKind::edge, ""}, {RelationKind::near, "bed-0"}};
  const auto step = builder.place("desk-0", wish);
  REQUIRE(step);
  CHECK(step->attempts.front().chosen->held == 2);
  CHECK(builder.scene().objects.back().relations == wish.relations);
}

TEST_CASE("What a host refuses is left out for its reason, and may be tried again") {
  Site site(bedroom());
  RoomBuilder& builder = site.builder;
  REQUIRE(builder.refuse("bed-0", "the guest brings a hammock"));
  step_through(builder);
  const auto made = builder.generation();
  REQUIRE(made.scene.unplaced.size() == 1);
  CHECK(made.scene.unplaced[0].id == "bed-0");
  CHECK(made.scene.unplaced[0].reason == "the guest brings a hammock");
  CHECK_FALSE(made.scene.incomplete);
  REQUIRE(builder.undo());
  (void)builder.undo(3);
  const auto again = builder.propose("bed-0");
  REQUIRE(again);
  REQUIRE(builder.place(*again));
  CHECK(builder.generation().scene.unplaced.size() == 3);  // those that are left
}

TEST_CASE("A host chooses what comes next") {
  Site site(bedroom());
  RoomBuilder& builder = site.builder;
  CHECK(builder.next()->id == "bed-0");
  REQUIRE(builder.choose("desk-0"));
  CHECK(builder.next()->id == "desk-0");
  const auto step = builder.step();
  REQUIRE(step);
  CHECK(step->planned.id == "desk-0");
  CHECK(builder.next()->id == "bed-0");
  CHECK_FALSE(builder.choose("desk-0"));
}

TEST_CASE("Events name what was placed, where, and what stands by then") {
  std::vector<std::string> lines;
  BuildOptions options;
  options.on_event = [&](const BuildEvent& event) {
    REQUIRE(event.scene);
    CHECK(event.total == 6);
    if (event.kind != BuildEvent::Kind::placed) return;
    REQUIRE(event.placed);
    CHECK(event.step->reason.empty());
    CHECK(event.scene->objects.size() == event.done);
    CHECK(event.scene->objects.back().id == event.object);
    CHECK(event.placed->position == event.scene->objects.back().position);
    lines.push_back(to_json(*event.step).dump());
  };
  Site site(bedroom(), options);
  step_through(site.builder);
  // The trace is their stream.
  std::vector<std::string> trace;
  for (const auto& step : site.builder.generation().trace) trace.push_back(to_json(step).dump());
  CHECK(lines == trace);
}

TEST_CASE("A call that is cancelled ends in the middle of reading a mesh") {
  HeldLibrary library;
  const auto designer = make_rule_designer();
  BuildOptions options;
  auto builder =
      RoomBuilder::begin(bedroom(), *designer, library, KindTable::built_in(), options);
  REQUIRE(builder);
  library.hold();
  std::thread stopper([&library, token = options.cancel]() mutable {
    library.wait_for_reader();
    token.cancel();
  });
  const auto step = builder->step();
  const int begun = library.begun(), ended = library.ended();
  library.let_go();
  stopper.join();
  CHECK(begun == 1);  // and it is still being read
  CHECK(ended == 0);
  REQUIRE_FALSE(step);
  CHECK(step.error().kind == Error::Kind::cancelled);
  CHECK(builder->scene().objects.empty());
  CHECK(builder->left().size() == 6);
  CHECK(builder->generation().scene.incomplete);
  CHECK_FALSE(builder->step());
}

TEST_CASE("A call that runs out of its time changes nothing and may be made again") {
  HeldLibrary library;
  const auto designer = make_rule_designer();
  auto builder = RoomBuilder::begin(bedroom(), *designer, library, KindTable::built_in());
  REQUIRE(builder);
  library.hold();
  const auto hasty = builder->step(RoomBuilder::Seconds(0.05));
  const int ended = library.ended();
  library.let_go();
  CHECK(ended == 0);  // no mesh was waited for
  REQUIRE_FALSE(hasty);
  CHECK(hasty.error().kind == Error::Kind::limit);
  CHECK(builder->scene().objects.empty());
  step_through(*builder);
  CHECK(text_of(builder->generation()) == made_at_one_go(bedroom()));
}

TEST_CASE("An improvement without time leaves the room as it is") {
  Site site(bedroom());
  while (site.builder.next()) REQUIRE(site.builder.step());
  const std::string before = text_of(site.builder.generation());
  CHECK_FALSE(site.builder.improve(RoomBuilder::Seconds(0.0)));
  CHECK(text_of(site.builder.generation()) == before);
}

TEST_CASE("Builders on several threads make the rooms that they make alone") {
  Plan other = bedroom();
  other.room = rooms::room_with_door(5, 5);
  const Plan plans[] = {bedroom(), other};
  std::string alone[2], together[2];
  for (int i = 0; i < 2; ++i) alone[i] = made_at_one_go(plans[i]);
  std::vector<std::thread> threads;
  for (int i = 0; i < 2; ++i)
    threads.emplace_back([&, i] {
      Site site(plans[i]);
      while (site.builder.next())
        if (!site.builder.step()) return;
      if (site.builder.improve()) together[i] = text_of(site.builder.generation());
    });
  for (auto& thread : threads) thread.join();
  for (int i = 0; i < 2; ++i) CHECK(together[i] == alone[i]);
}
