#include "evaluate/clauses.h"
#include "evaluate/ledger.h"

#include "catch.h"
#include "evaluate/attributes.h"
#include "evaluate/identity.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

// A bed at the back wall, a nightstand beside it, a lamp on that.
Scene bedroom() {
  Scene scene;
  scene.room = rooms::box(4, 4);
  scene.room.type = "bedroom";
  scene.room.materials.floor = "oak floor";
  scene.objects = {rooms::thing("bed-0", "bed", {1.6, 2.0, 0.5}, {2, 3}),
                   rooms::thing("nightstand-0", "nightstand", {0.4, 0.4, 0.5}, {3.05, 3.75}),
                   rooms::thing("table lamp-0", "table lamp", {0.2, 0.2, 0.4}, {3.05, 3.75})};
  scene.objects[2].position.z() = 0.5;
  scene.objects[2].mount = Mount::surface;
  scene.objects[2].on = "nightstand-0";
  scene.unplaced = {{"rug-0", "rug", "no room"}};
  return scene;
}

Requirement about(Requirement::Kind kind, const std::string& category,
                  std::vector<std::string> subjects) {
  Requirement requirement;
  requirement.kind = kind;
  requirement.category = category;
  requirement.subjects = std::move(subjects);
  return requirement;
}

RequirementVerdict check(const Requirement& requirement) {
  const AttributeJudge judge = [](const Object& object, const std::string& word) {
    AttributeVerdict verdict;
    verdict.held = object.id == "bed-0" && word == "white";
    verdict.reason = verdict.held ? "" : "is not " + word;
    return verdict;
  };
  return check_requirements(std::vector{requirement}, bedroom(), KindTable::built_in(), judge)[0];
}

}  // namespace

TEST_CASE("Numbers are met exactly unless more are as good") {
  auto wanted = about(Requirement::Kind::count, "bed", {"bed-0"});
  CHECK(check(wanted).met());
  wanted.count = 2;
  CHECK_FALSE(check(wanted).met());
  CHECK(check(wanted).reason == "there are 1 instead of 2");
  wanted.count = 0;
  wanted.at_least = true;
  CHECK(check(wanted).met());
  // What was left out is missing, with the reason.
  const auto rug = check(about(Requirement::Kind::count, "rug", {"rug-0"}));
  CHECK_FALSE(rug.met());
  CHECK(rug.reason == "rug-0 was left out: no room");
}

TEST_CASE("What its mesh shows to be of another kind does not count, whatever it was placed as") {
  Scene scene = bedroom();
  const auto verdict = [&](const std::string& kind, const Requirement& wanted) {
    scene.objects[1].asset.procedural = ProceduralSource{"words", "{\"kind\": \"" + kind + "\"}", 0};
    return check_requirements(std::vector{wanted}, scene, KindTable::built_in(), {})[0];
  };
  const auto wanted = about(Requirement::Kind::count, "nightstand", {"nightstand-0"});
  CHECK(verdict("nightstand", wanted).met());
  CHECK(verdict("floating nightstand", wanted).met());
  CHECK_FALSE(verdict("bathtub", wanted).met());
  CHECK(verdict("bathtub", wanted).reason == "nightstand-0 is a bathtub");
  // Nor is a thing away because it was placed as another.
  CHECK_FALSE(verdict("bathtub", about(Requirement::Kind::absence, "bathtub", {})).met());
  CHECK(verdict("nightstand", about(Requirement::Kind::absence, "bathtub", {})).met());
}

TEST_CASE("What a description asks for is evidence of nothing: blanked, it changes no verdict") {
  Scene scene = bedroom();
  for (auto& object : scene.objects) object.description = "huge red velvet canopy four drawer " + object.category;
  std::vector<Requirement> all;
  for (const auto& object : scene.objects) {
    all.push_back(about(Requirement::Kind::count, object.category, {object.id}));
    all.push_back(about(Requirement::Kind::absence, object.category, {}));
    for (const char* look : {"red", "velvet", "canopy", "four drawer", "huge", "glass"})
      for (const auto kind : {Requirement::Kind::attribute, Requirement::Kind::absence}) {
        all.push_back(about(kind, object.category, {object.id}));
        all.back().attribute = look;
      }
  }
  const AttributeJudge judge = [](const Object& object, const std::string& word) {
    return judge_attribute(known_looks(object, ModelTable()), word);
  };
  const auto described = check_requirements(all, scene, KindTable::built_in(), judge);
  for (auto& object : scene.objects) object.description.clear();
  const auto blanked = check_requirements(all, scene, KindTable::built_in(), judge);
  for (std::size_t i = 0; i < all.size(); ++i) {
    INFO(all[i].category << " " << all[i].attribute);
    CHECK(described[i].compliance == blanked[i].compliance);
    CHECK(described[i].reason == blanked[i].reason);
  }
}

TEST_CASE("Things of which another number speaks are not counted") {
  Scene scene = bedroom();
  scene.objects.push_back(rooms::thing("bed-1", "bed", {1.6, 2.0, 0.5}, {1, 1}));
  const auto first = about(Requirement::Kind::count, "bed", {"bed-0"});
  const auto second = about(Requirement::Kind::count, "bed", {"bed-1"});
  const auto met = [&](const std::vector<Requirement>& all) {
    return check_requirements(all, scene, KindTable::built_in(), {})[0].met();
  };
  CHECK(met({first, second}));
  CHECK_FALSE(met({first}));
}

TEST_CASE("Relations hold for every subject towards one of the targets") {
  auto wanted = about(Requirement::Kind::relation, "table lamp", {"table lamp-0"});
  wanted.relation = RelationKind::on;
  wanted.targets = {"bed-0", "nightstand-0"};
  CHECK(check(wanted).met());
  wanted.targets = {"bed-0"};
  CHECK_FALSE(check(wanted).met());
  wanted = about(Requirement::Kind::relation, "nightstand", {"nightstand-0"});
  wanted.relation = RelationKind::near;
  wanted.targets = {"bed-0"};
  CHECK(check(wanted).met());
  wanted.relation = RelationKind::middle;
  wanted.targets.clear();
  CHECK_FALSE(check(wanted).met());
}

TEST_CASE("Materials are those of the room") {
  Requirement requirement = about(Requirement::Kind::attribute, "floor", {});
  requirement.attribute = "oak floor";
  CHECK(check(requirement).met());
  requirement.attribute = "walnut floor";
  CHECK(check(requirement).reason == "partly: drawn as beige boards");
  requirement.category = "accent wall";
  CHECK_FALSE(check(requirement).met());
}

TEST_CASE("A finish is what is drawn, whatever it is called") {
  Scene scene = bedroom();
  const auto fault = [&](const std::string& part, const std::string& asked, const std::string& worn) {
    auto& materials = scene.room.materials;
    (part == "floor" ? materials.floor : part == "walls" ? materials.walls : materials.ceiling) = worn;
    auto wanted = about(Requirement::Kind::attribute, part, {});
    wanted.attribute = asked;
    const auto never = [](const Object&, const std::string&) { return AttributeVerdict{}; };
    return check_requirements({&wanted, 1}, scene, KindTable::built_in(), never).front().reason;
  };
  CHECK(fault("floor", "riveted iron", "dark metal plates floor") ==
        "partly: drawn as metal plates; nothing draws \"riveted\"");
  CHECK(fault("floor", "terrazzo", "white terrazzo floor").find("\"terrazzo\"") != std::string::npos);
  CHECK(fault("floor", "pebbled", "dark grey pebbles floor") != "");
  CHECK(fault("ceiling", "white with black dashes", "white with black dashes") ==
        "partly: drawn as white, plain; nothing draws \"dashes\"");
  CHECK(fault("walls", "lilac silk", "plain lilac silk walls") ==
        "partly: drawn as plain paint; nothing draws \"silk\"");
  CHECK(fault("walls", "pink", "dusty rose plaster") == "");
  CHECK(fault("walls", "pink", "sage green walls") != "");
  CHECK(fault("walls", "cobalt and yellow tiles", "cobalt blue and yellow talavera tiles") == "");
  CHECK(fault("walls", "blue", "cobalt blue plaster") == "");
  CHECK(fault("walls", "cobalt tiles", "white tiles") != "");
  CHECK(fault("floor", "parquet", "honey oak herringbone parquet floor") == "");
  CHECK(fault("floor", "wide oak boards", "wide oak boards") == "");
  CHECK(fault("floor", "black and white checkerboard", "white black checkerboard") == "");
}

TEST_CASE("Light is as it is lit") {
  const Lighting night{22.0, Sky::night, 8.0, 1800.0, {}};
  CHECK(judge_light("candlelight", night).compliance == Compliance::met);
  CHECK(judge_light("bright noon", night).compliance == Compliance::not_met);
  CHECK(judge_light("soft starry night-light", night).reason ==
        "partly: lit at 22 h, night, 8 lx, 1800 K; nothing shows \"starry night\"");
  CHECK(judge_light("evening dresses on a rail", night).compliance == Compliance::not_judged);
  CHECK(judge_light("fills one corner", night).compliance == Compliance::not_judged);
}

TEST_CASE("Attributes are judged by who knows them, absences by what is there") {
  auto wanted = about(Requirement::Kind::attribute, "bed", {"bed-0"});
  wanted.attribute = "white";
  CHECK(check(wanted).met());
  wanted.attribute = "round";
  CHECK(check(wanted).reason == "bed-0: is not known to be round: is not round");
  CHECK(check(about(Requirement::Kind::absence, "television", {})).met());
  CHECK_FALSE(check(about(Requirement::Kind::absence, "nightstand", {})).met());
}

TEST_CASE("Of a stand-in nothing shows that it is the thing, nor that the thing is where it stands") {
  Scene scene = bedroom();
  scene.objects.push_back(rooms::thing("tuba-0", "tuba", {0.6, 0.3, 0.9}, {0.5, 0.5}));
  scene.objects.back().stand_in = true;
  const AttributeJudge judge = [](const Object&, const std::string&) { return AttributeVerdict{}; };
  auto near_bed = about(Requirement::Kind::relation, "tuba", {"tuba-0"});
  near_bed.relation = RelationKind::far;
  near_bed.targets = {"nightstand-0"};
  const std::vector<Requirement> asked = {about(Requirement::Kind::count, "tuba", {"tuba-0"}), near_bed};
  const auto verdicts = check_requirements(asked, scene, KindTable::built_in(), judge);
  CHECK(verdicts[0].compliance == Compliance::not_judged);
  CHECK(verdicts[0].reason == "nothing shows that tuba-0 is one");
  CHECK(verdicts[1].compliance == Compliance::not_judged);
  CHECK(verdicts[1].reason == "nothing shows that tuba-0 is what was asked for");
  CHECK(identified_as(scene.objects, {"tuba"}).at("tuba").empty());
}

TEST_CASE("What hangs is at a height that lies between its bottom and its top") {
  Scene scene = bedroom();
  scene.objects.push_back(rooms::thing("mirror-0", "wall mirror", {0.6, 0.05, 0.8}, {2, 0.05}));
  auto wanted = about(Requirement::Kind::attribute, "wall mirror", {"mirror-0"});
  wanted.attribute = height_above_floor;
  wanted.amount = 1.5;
  const auto met = [&](double bottom) {
    scene.objects.back().position.z() = bottom;
    return check_requirements(std::vector{wanted}, scene, KindTable::built_in(), {})[0].met();
  };
  CHECK(met(0.71));
  CHECK(met(1.1));
  CHECK(met(1.54));
  CHECK_FALSE(met(0.6));
  CHECK_FALSE(met(1.6));
  wanted.at_least = true;
  CHECK(met(1.6));
  CHECK_FALSE(met(0.6));
  wanted.at_least = false, wanted.at_most = true;
  CHECK_FALSE(met(1.6));
  CHECK(met(0.6));
}

TEST_CASE("A room is of a style when half of its furniture is, and in colours that are all there") {
  Scene scene = bedroom();
  scene.objects.push_back(rooms::thing("desk-0", "desk", {1.2, 0.6, 0.75}, {1, 0.5}));
  std::vector<std::string> rustic;
  const AttributeJudge judge = [&](const Object& object, const std::string& word) {
    AttributeVerdict verdict;
    verdict.held = word == "rustic" ? std::find(rustic.begin(), rustic.end(), object.id) != rustic.end()
                                    : word == "navy" && object.id == "table lamp-0";
    return verdict;
  };
  const auto check_room = [&](std::string_view what, const std::string& said) {
    Requirement wanted;
    wanted.kind = Requirement::Kind::room;
    wanted.attribute = what;
    wanted.category = said;
    return check_requirements(std::vector{wanted}, scene, KindTable::built_in(), judge)[0];
  };
  // Three pieces of furniture; the lamp on the nightstand is none.
  rustic = {"bed-0", "table lamp-0"};
  CHECK(check_room(style_of_room, "rustic").reason == "1 of 3 pieces of furniture are so");
  rustic = {"bed-0", "desk-0"};
  CHECK(check_room(style_of_room, "rustic").met());
  CHECK(check_room(style_of_room, "cosy").compliance == Compliance::not_judged);
  CHECK(check_room(palette_of_room, "navy").met());
  CHECK(check_room(palette_of_room, "navy oak").met());  // the floor is of oak
  CHECK(check_room(palette_of_room, "navy red").reason == "nothing is known to be red");
}
