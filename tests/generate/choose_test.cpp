#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "catch.h"
#include "roomgen/create/create.h"
#include "roomgen/generate/room_builder.h"
#include "small_plans.h"
#include "support/contains.h"

using namespace roomgen;
using rooms::plan_of;
using rooms::room_with_door;
using Take = AssetChoice::Kind;

namespace {

/// Has three things of every kind, which differ in size; the best answer to words that name one is
/// that one.
class Shelf final : public AssetLibrary {
 public:
  Result<std::vector<AssetMatch>> search(const AssetQuery& query) const override {
    std::vector<AssetMatch> matches;
    if (query.made) return matches;
    for (const char* name : {"a", "b", "c"}) {
      AssetMatch match{thing(query.category + "-" + name)};
      match.score = query.description == match.asset.ref.id ? 0.9 : 0.7 - 0.2 * (name[0] - 'a');
      matches.push_back(match);
    }
    std::stable_sort(matches.begin(), matches.end(),
                     [](const auto& a, const auto& b) { return a.score > b.score; });
    if (matches.size() > query.limit) matches.resize(query.limit);
    return matches;
  }
  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override {
    if (ref.library != "shelf") return AssetLibrary::find(asset_key(ref)).error();
    auto model = std::make_shared<Model>();
    model->materials.emplace_back();
    const Vec3 size = thing(ref.id).size;
    model->parts.push_back({make_box({-0.5 * size.x(), -0.5 * size.y(), 0},
                                     {0.5 * size.x(), 0.5 * size.y(), size.z()}),
                            0});
    return std::shared_ptr<const Model>(std::move(model));
  }
  Result<AssetInfo> find(std::string_view key) const override {
    const bool is_here =
        key.starts_with("shelf/") && key[key.size() - 2] == '-' && key.find('#') == key.npos;
    return is_here ? thing(std::string(key.substr(6))) : AssetLibrary::find(key);
  }

 private:
  static AssetInfo thing(const std::string& id) {
    AssetInfo asset;
    asset.ref.library = "shelf";
    asset.ref.id = asset.name = id;
    asset.category = id.substr(0, id.rfind('-'));
    asset.size = Vec3::Constant(0.5 + 0.05 * (id.back() - 'a'));
    return asset;
  }
};

std::unique_ptr<AssetLibrary> shop() {
  return make_first_of(
      {create::make_finishing_library(std::make_unique<Shelf>()), create::make_created_library()});
}

/// Chooses as a function says; things stand wherever the solver likes them.
class Chooser final : public Designer {
 public:
  using Answer = std::function<Result<AssetChoices>(const ChoiceRequest&)>;
  explicit Chooser(Answer answer = {}) : answer_(std::move(answer)) {}

  Result<Plan> plan(const PlanRequest&) override { return Plan(); }
  bool chooses() const override { return answer_ != nullptr; }
  Result<AssetChoices> choose(const ChoiceRequest& request) override {
    asked.push_back(request.offers);
    return answer_(request);
  }
  Result<PlaceAdvice> place(const PlaceRequest&) override { return PlaceAdvice(); }

  bool makes() const override { return writes != nullptr; }
  Result<ThingsMade> make(const MakingRequest& request) override {
    made.push_back(request.things);
    return writes(request);
  }

  std::vector<std::vector<AssetOffer>> asked;
  std::vector<std::vector<ThingToMake>> made;
  std::function<Result<ThingsMade>(const MakingRequest&)> writes;

 private:
  Answer answer_;
};

PlanItem item(const std::string& category, const std::string& description, int quantity = 1) {
  PlanItem result = rooms::item(category, Mount::floor, quantity);
  result.description = description;
  result.asked = true;
  return result;
}

Plan five_things() {
  return plan_of({item("chair", "oak chair", 2), item("desk", "desk"), item("chair", "oak chair"),
                  item("floor lamp", "floor lamp"), item("plant", "plant")},
                 room_with_door(7, 7));
}

AssetChoices some_of_everything(const ChoiceRequest&) {
  AssetChoices answer;
  answer.choices = {
      {0, Take::asset, 2}, {1, Take::asset, 1}, {2, Take::make}, {3, Take::leave_out}};
  answer.choices[1].paint = "navy blue";
  answer.choices[2].words = "a floor lamp with a black pole and a white shade";
  answer.choices[2].size = Vec3(0.4, 0.4, 1.5);
  answer.choices[3].reason = "none is green";
  answer.consultation.calls = 1;
  return answer;
}

Generation furnished(const Plan& plan, Chooser& designer, const AssetLibrary& library) {
  auto generation = generate(plan, designer, library, KindTable::built_in());
  if (!generation) FAIL(generation.error().message);
  return *std::move(generation);
}

std::vector<std::string> keys_of(const Generation& generation) {
  std::vector<std::string> keys;
  for (const auto& object : generation.scene.objects)
    keys.push_back(object.id + " " + asset_key(object.asset));
  return keys;
}

bool says(const std::vector<std::string>& notes, const std::string& text) {
  return std::any_of(notes.begin(), notes.end(),
                     [&](const std::string& note) { return contains_text(note, text); });
}

}  // namespace

TEST_CASE("What a designer chooses is what stands, and what it leaves out is told") {
  const auto library = shop();
  Chooser designer(some_of_everything);
  const Generation room = furnished(five_things(), designer, *library);
  REQUIRE(designer.asked.size() == 1);
  const auto& offers = designer.asked.front();
  REQUIRE(offers.size() == 4);  // alike words once
  CHECK(offers[0].count == 3);
  CHECK(offers[0].items == std::vector<std::size_t>{0, 2});
  for (const auto& offer : offers)
    for (const auto& one : offer.assets) {
      const auto found = library->find(asset_key(one.asset.ref));
      REQUIRE(found);
      CHECK(to_json(found->ref) == to_json(one.asset.ref));
      CHECK(asset_key(found->ref) == asset_key(one.asset.ref));
      CHECK(library->load(one.asset.ref));
    }
  REQUIRE(room.scene.objects.size() == 5);
  for (const auto& object : room.scene.objects) {
    if (object.category == "chair") CHECK(object.asset.id == "chair-c");
    if (object.category == "desk") CHECK_FALSE(object.asset.finish.empty());
    if (object.category == "floor lamp") {
      REQUIRE(object.asset.procedural);
      CHECK(text_parameter(*object.asset.procedural, "description") ==
            "a floor lamp with a black pole and a white shade");
      CHECK(std::abs(object.size.z() - 1.5) < 0.01);
    }
  }
  REQUIRE(room.scene.unplaced.size() == 1);
  CHECK(room.scene.unplaced[0].id == "plant-0");
  CHECK(contains_text(room.scene.unplaced[0].reason, "none is green"));
  CHECK(says(room.notes, "none is green"));
  CHECK(room.model_use.calls == 1);
  REQUIRE(room.choices.size() == 1);
  const Json line = to_json(room.choices.front());
  CHECK(line["choice"][0]["answer"]["take"] == "1c");
  CHECK(line["choice"][0]["taken"] == "shelf/chair-c#wood=oak");
  CHECK(line["choice"][0]["assets"].size() == offers[0].assets.size());
}

namespace {

// A board on a post, in colours of its own, `times` as large as 0.6 x 0.4 x 0.5 m.
std::string stand(double times) {
  const auto box = [&](const char* name, const Vec3& size, double at) {
    return Json{{"name", name},
                {"label", name},
                {"box", {{"size", {times * size.x(), times * size.y(), times * size.z()}}}},
                {"at", {0, 0, times * at}},
                {"material", name}};
  };
  return json_line({{"format", "roomgen-shape"},
                    {"version", 1},
                    {"name", "anything"},
                    {"materials", {{"post", {{"color", "#123456"}}}, {"top", {{"color", "mint"}}}}},
                    {"components", {box("post", {0.3, 0.3, 0.46}, 0.0), box("top", {0.6, 0.4, 0.05}, 0.45)}},
                    {"connections", {{"post", "floor"}, {"top", "post"}}}});
}

AssetChoices everything_made(const ChoiceRequest& request) {
  AssetChoices answer;
  for (std::size_t i = 0; i < request.offers.size(); ++i) {
    answer.choices.push_back({i, Take::make});
    answer.choices.back().size = Vec3(0.6, 0.4, 0.5);
    answer.choices.back().paint = "navy blue";
  }
  return answer;
}

}  // namespace

TEST_CASE("What a designer makes stands in its size and its own colours, and is made again from the plan") {
  const auto library = shop();
  Chooser designer(everything_made), silent;
  designer.writes = [](const MakingRequest& request) -> Result<ThingsMade> {
    ThingsMade answer;
    answer.consultation.calls = 1;
    const std::string broken = R"({"components": [{"name": "a", "box": {"size": [1, 2]}}]})";
    if (request.again && request.things.size() == 2) return answer;
    if (request.again) answer.programs = {{0, stand(1.7)}, {1, broken}, {2, broken}};
    if (!request.again)
      answer.programs = {{0, broken}, {1, stand(1.0)}, {2, stand(30.0)}, {3, stand(1.0)}};
    return answer;
  };
  const Plan plan = plan_of({item("carousel horse", "a white carousel horse"), item("desk", "desk"),
                             item("floor lamp", "floor lamp"), item("plant", "plant")},
                            room_with_door(7, 7));
  const Generation room = furnished(plan, designer, *library);
  REQUIRE(designer.made.size() == 3);  // all a second time, what was broken then a third
  REQUIRE(designer.made[2].size() == 2);
  CHECK(designer.made[2][0].offer.id == "2");
  CHECK(contains_text(designer.made[0][0].offer.words, "navy blue"));
  CHECK(says(designer.made[1][0].notes, "/components/0"));
  CHECK(says(designer.made[1][2].notes, "large"));
  REQUIRE(room.scene.objects.size() == 4);
  for (const auto& object : room.scene.objects) {
    INFO(object.id);
    REQUIRE(object.asset.procedural);
    const bool is_written = object.category != "floor lamp";
    CHECK((object.asset.procedural->recipe == "program") == is_written);
    if (!is_written) continue;
    CHECK(object.size.isApprox(Vec3(0.6, 0.4, 0.5), 0.02));
    CHECK(object.asset.finish.empty());
    CHECK(contains_text(object.asset.procedural->params, "#123456"));
    CHECK(text_parameter(*object.asset.procedural, "name") == object.category);
  }
  CHECK(says(room.notes, "3. rules make it"));
  CHECK(says(room.notes, "the one before stays"));
  CHECK(room.model_use.calls == 3);
  REQUIRE(room.choices.size() == 4);
  const Json line = to_json(room.choices[2]);
  CHECK(line["making"].size() == 4);
  CHECK(line["making"][0]["program"]["components"].size() == 2);
  CHECK(line["making"][2].contains("taken") == false);

  const auto again = plan_from_json(to_json(room.chosen.front()), "plan.json");
  REQUIRE(again);
  CHECK(keys_of(furnished(*again, silent, *library)) == keys_of(room));
}

TEST_CASE("A plan with what was chosen makes the same room again without a designer that chooses") {
  const auto library = shop();
  Chooser designer(some_of_everything), silent;
  const Generation first = furnished(five_things(), designer, *library);
  REQUIRE(first.chosen.size() == 1);
  const auto plan = plan_from_json(to_json(first.chosen.front()), "plan.json");
  REQUIRE(plan);
  CHECK(plan->items[0].asset == "shelf/chair-c#wood=oak");
  for (const auto& object : first.scene.objects)
    if (object.category == "chair") CHECK(object.size.isApprox(*plan->items[0].size, 1e-3));
  CHECK_FALSE(plan->items[4].left_out.empty());
  const Generation again = furnished(*plan, silent, *library);
  CHECK(keys_of(again) == keys_of(first));
  REQUIRE(again.scene.unplaced.size() == 1);
  CHECK(again.scene.unplaced[0].reason == first.scene.unplaced[0].reason);
}

TEST_CASE(
    "What is searched by other words is offered once more, the first asset of before with it") {
  const auto library = shop();
  Chooser designer([](const ChoiceRequest& request) -> Result<AssetChoices> {
    AssetChoices answer;
    if (!request.again) answer.choices = {{1, Take::search}};
    if (!request.again) answer.choices[0].words = "desk-b";
    return answer;
  });
  Plan plan = plan_of({item("chair", "chair"), item("desk", "desk-c")}, room_with_door(6, 6));
  const Generation room = furnished(plan, designer, *library);
  REQUIRE(designer.asked.size() == 2);
  REQUIRE(designer.asked[1].size() == 1);
  const AssetOffer& again = designer.asked[1][0];
  CHECK(again.id == "2");
  CHECK(again.words == "desk-b");
  CHECK(again.assets.front().asset.ref.id == "desk-b");
  std::set<std::string> ids;
  for (const auto& one : again.assets) ids.insert(asset_key(one.asset.ref));
  CHECK(ids.size() == again.assets.size());
  CHECK(ids.count(asset_key(designer.asked[0][1].assets.front().asset.ref)) == 1);
  CHECK(room.choices.size() == 2);
}

TEST_CASE("An asset that no library has is told, and the words decide") {
  const auto library = shop();
  Chooser designer;
  Plan plan = plan_of({item("chair", "chair-b")}, room_with_door(5, 5));
  plan.items[0].asset = "elsewhere/throne";
  const Generation room = furnished(plan, designer, *library);
  REQUIRE(room.scene.objects.size() == 1);
  CHECK(room.scene.objects[0].asset.id == "chair-b");
  CHECK(says(room.notes, "elsewhere/throne"));
}

TEST_CASE("A designer that may ask no more ends the room before anything stands") {
  const auto library = shop();
  Chooser designer([](const ChoiceRequest&) -> Result<AssetChoices> {
    return Error{Error::Kind::limit, "the money is spent"};
  });
  const Generation room = furnished(five_things(), designer, *library);
  CHECK(room.scene.objects.empty());
  CHECK(room.scene.incomplete);
  CHECK(room.stopped == "the money is spent");

  Chooser spent(everything_made);
  spent.writes = [](const MakingRequest&) -> Result<ThingsMade> {
    return Error{Error::Kind::limit, "no more calls"};
  };
  CHECK(furnished(five_things(), spent, *library).stopped == "no more calls");
}
