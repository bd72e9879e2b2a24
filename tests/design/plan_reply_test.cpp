#include "plan_reply.h"

#include "plan_form.h"

#include <nlohmann/json.hpp>

#include "base/random.h"
#include "brief/prompt.h"
#include "catch.h"
#include "roomgen/base/text.h"
#include "support/contains.h"
#include "support/damaged.h"
#include "support/rooms.h"

using namespace roomgen;
using namespace roomgen::brief;
using namespace roomgen::design;

namespace {

Result<PlanReply> reply_to(const PlanRequest& request, const std::string& answer) {
  const Brief brief = read_prompt(request.prompt, *built_in_room_kinds(), KindTable::built_in());
  return read_plan_reply(answer, request, brief, KindTable::built_in());
}

PlanReply read(const std::string& answer,
               const PlanRequest& request = {"a bedroom", 1, {}, {}, {}}) {
  INFO(answer);
  auto reply = reply_to(request, answer);
  if (!reply) INFO(reply.error().message);
  REQUIRE(reply);
  REQUIRE(check(reply->plan.room));
  return *std::move(reply);
}

const PlanItem& item(const Plan& plan, const std::string& category) {
  for (const auto& one : plan.items)
    if (one.category == category) return one;
  FAIL("no " + category);
  return plan.items.front();
}

std::string with_room(const std::string& room) {
  return R"({"room": )" + room + R"(, "objects": [{"name": "bed"}]})";
}

std::string with_object(const std::string& object) {
  return R"({"room": {"type": "bedroom", "size_m": [5, 4]}, "objects": [)" + object + "]}";
}

const char* const good =
    R"({"room": {"type": "bedroom", "size_m": [4.2, 3.6], "height_m": 2.6},
        "objects": [
          {"name": "nightstand", "description": "a small oak nightstand", "size_cm": [45, 40, 50],
           "quantity": 2, "variance": "same", "place": "floor",
           "on_top": [{"name": "table lamp", "size_cm": [25, 25, 45], "quantity": 2}]},
          {"name": "bed", "description": "a double bed with a blue quilt",
           "size_cm": [160, 210, 90], "quantity": 1, "place": "floor"},
          {"name": "painting", "size_cm": [80, 4, 60], "quantity": 3, "variance": "varied",
           "place": "wall"}],
        "excluded": ["television"]})";

}  // namespace

TEST_CASE("A well-formed plan is taken as it is") {
  const PlanReply reply = read(good);
  const Plan& plan = reply.plan;
  CHECK(reply.repairs.empty());
  CHECK(plan.room.type == "bedroom");
  CHECK(bounds(plan.room.polygon).size().isApprox(Vec2(4.2, 3.6)));
  CHECK(plan.room.height == Approx(2.6));
  CHECK(find_opening(plan.room, "door-0"));
  CHECK(plan.items.front().category == "bed");
  CHECK(item(plan, "bed").size->isApprox(Vec3(1.6, 2.1, 0.9)));
  CHECK(item(plan, "bed").description == "a double bed with a blue quilt");
  CHECK(item(plan, "nightstand").quantity == 2);
  const PlanItem& lamp = item(plan, "table lamp");
  CHECK(lamp.mount == Mount::surface);
  CHECK(lamp.on == "nightstand");
  CHECK(to_text(lamp.relations) == "on, nightstand-0");
  CHECK(plan.items.size() == 5);  // each lamp with a nightstand of its own
  CHECK(plan.excluded.size() == 1);
}

TEST_CASE("Rooms are understood however they are written") {
  struct Written {
    const char* room;
    double width, depth;
    bool repaired;
  };
  const Written cases[] = {
      {R"({"size_m": [4, 3]})", 4, 3, false},
      {R"({"Size": "4 x 3 m"})", 4, 3, false},
      {R"({"size_m": ["4 m", "300 cm"]})", 4, 3, false},
      {R"({"size_m": {"width": 4, "depth": 3}})", 4, 3, false},
      {R"({"width": 4, "length": 3})", 4, 3, false},
      {R"({"dimensions": [400, 300]})", 4, 3, false},
      {R"({"size_m": [0.1, 3]})", 0.5, 3, true},
      {R"({"polygon_m": [[0, 0], [4, 0], [4, 3], [0, 3]]})", 4, 3, false},
      {R"({"polygon_m": [[1, 1], [1, 4], [3, 4], [3, 3], [5, 3], [5, 1]]})", 4, 3, false},
      {R"({"polygon_m": [[0, 0], [4, 3], [4, 0], [0, 3]]})", 4, 3, true},
      {R"({"vertices": [{"x": 0, "y": 0}, {"x": 4, "y": 0}, {"x": 4, "y": 3}]})", 4, 3, false},
  };
  for (const auto& one : cases) {
    const PlanReply reply = read(with_room(one.room));
    INFO(one.room << " " << join(reply.repairs, "; "));
    CHECK(bounds(reply.plan.room.polygon).size().isApprox(Vec2(one.width, one.depth)));
    CHECK(!reply.repairs.empty() == one.repaired);
  }
  CHECK(!read(with_room("\"bedroom\"")).repairs.empty());
  CHECK(read(with_room("{\"height_m\": 300}")).plan.room.height == Approx(3.0));
}

TEST_CASE("The request wins over the answer") {
  PlanRequest request{"a bedroom without a desk", 1, Vec2(6, 5), {}, {}};
  const auto sized = read(R"({"room": {"size_m": [4, 3]}, "objects": ["bed", "desk"]})", request);
  CHECK(bounds(sized.plan.room.polygon).size().isApprox(Vec2(6, 5)));
  CHECK(sized.plan.items.size() == 1);
  request.room = rooms::box(7, 3);
  CHECK(bounds(read(good, request).plan.room.polygon).size().isApprox(Vec2(7, 3)));
}

TEST_CASE("A thing is what its name ends with, whatever else its name and description speak of") {
  const std::pair<const char*, const char*> wrong[] = {
      {"pie case", "pie"}, {"napkin dispenser", "napkin"}, {"gumball machine", "ball"},
      {"butterfly cabinet", "butterfly"}, {"gaslight", "wall lamp"}};
  for (const auto& [name, other] : wrong) {
    INFO(name);
    const auto reply = read(with_object(std::string(R"({"name": ")") + name +
                                        R"(", "description": "brass, beside a wall lamp",
                                           "size_cm": [30, 30, 40]})"));
    REQUIRE(reply.plan.items.size() == 1);
    CHECK(reply.plan.items[0].category != other);
    if (reply.plan.items[0].category != name)
      CHECK(reply.plan.items[0].description == std::string(name) + ", brass, beside a wall lamp");
  }
}

TEST_CASE("A thing that shares a word with a kind, but neither its size nor its sort, is a kind of its own") {
  const auto kind = [](const std::string& thing, const std::string& room = "salon") {
    return read(R"({"room": {"type": ")" + room + R"(", "size_m": [9, 9], "height_m": 4}, "objects": [)" +
                thing + "]}").plan.items.front().category;
  };
  CHECK(kind(R"({"name": "scent organ", "size_cm": [200, 110, 135],
                 "description": "perfumer's organ, walnut"})") == "scent-organ");
  CHECK(kind(R"({"name": "boiler", "size_cm": [130, 130, 240],
                 "description": "riveted copper steam boiler, brass face"})") == "steam-boiler");
  CHECK(kind(R"({"name": "boiler", "size_cm": [45, 45, 90]})") == "water heater");
  CHECK(kind(R"({"name": "glass counter", "size_cm": [150, 52, 95]})") == "glass-counter");
  CHECK(kind(R"({"name": "tiled counter", "size_cm": [150, 62, 90]})", "kitchen") == "kitchen counter");
  CHECK(kind(R"({"name": "minbar", "description": "carved minbar of twelve steps"})") == "minbar");
  CHECK(kind(R"({"name": "milking stool", "size_cm": [34, 34, 38]})") == "stool");
  CHECK(kind(R"({"name": "mural", "size_cm": [300, 2, 220]})") == "picture");
  CHECK(kind(R"({"name": "crystal chandelier", "size_cm": [220, 220, 240]})") == "chandelier");
  // It is still what the wish asks for.
  const auto reply = read(R"({"objects": [{"name": "glass counter", "size_cm": [150, 52, 95],
    "on_top": [{"name": "vase"}]}, {"name": "bowl", "place": "on glass counter"}]})");
  CHECK(reply.plan.items[1].on == "glass-counter");
  CHECK(reply.plan.items[2].on == "glass-counter");
  const auto shown = read(R"({"objects": [{"name": "display cabinet"}, {"name": "dodo", "size_cm": [40, 30, 50],
    "place": "in the display cabinet"}]})");
  CHECK(to_text(item(shown.plan, "dodo").relations) == "on, display cabinet-0 | inside, display cabinet-0");
}

TEST_CASE("Objects are understood however they are written") {
  struct Written {
    const char* object;
    const char* category;
    Vec3 size;
    int quantity;
    Mount mount;
    bool repaired;
  };
  const Vec3 bed(1.6, 2.05, 0.9);
  const Written cases[] = {
      {R"("bed")", "bed", bed, 1, Mount::floor, false},
      {R"({"name": "Bed_1", "quantity": "2"})", "bed", bed, 2, Mount::floor, false},
      {R"({"name": "Beds", "count": "two"})", "bed", bed, 2, Mount::floor, false},
      {R"({"object": "bed", "size": [1.4, 2, 0.5]})", "bed", {1.4, 2, 0.5}, 1, Mount::floor, false},
      {R"({"name": "bed", "size_cm": [1.4, 2, 0.5]})",
       "bed",
       {1.4, 2, 0.5},
       1,
       Mount::floor,
       false},
      {R"({"name": "bed", "size_cm": "140 x 200 x 50 cm"})",
       "bed",
       {1.4, 2, 0.5},
       1,
       Mount::floor,
       false},
      {R"({"name": "bed", "dimensions": {"height": 50, "width": 140, "depth": 200}})",
       "bed",
       {1.4, 2, 0.5},
       1,
       Mount::floor,
       false},
      {R"({"name": "bed", "size_cm": "large"})", "bed", bed, 1, Mount::floor, true},
      {R"({"name": "bed", "quantity": 70})", "bed", bed, 50, Mount::floor, true},
      {R"({"name": "bed", "quantity": "lots of them"})", "bed", bed, 6, Mount::floor, false},
      {R"({"name": "bed", "quantity": -3})", "bed", bed, 1, Mount::floor, true},
      {R"({"name": "bed", "size_cm": [900, 210, 0.1]})",
       "bed",
       {5, 2.1, 0.02},
       1,
       Mount::floor,
       true},
      {R"({"name": "thing for sleeping", "description": "a bed"})", "bed", bed, 1, Mount::floor,
       false},
      {R"({"name": "Flux Frobnicator", "size_cm": [50, 50, 50]})",
       "flux frobnicator",
       {.5, .5, .5},
       1,
       Mount::floor,
       true},
      {R"({"name": "bed", "place": "hung from the ceiling"})", "bed", bed, 1, Mount::ceiling,
       false},
      {R"({"name": "bed", "place": "on piano"})", "bed", bed, 1, Mount::floor, true},
  };
  for (const auto& one : cases) {
    const PlanReply reply = read(with_object(one.object));
    INFO(one.object << " " << join(reply.repairs, "; "));
    REQUIRE(reply.plan.items.size() == 1);
    const PlanItem& read = reply.plan.items.front();
    CHECK(read.category == one.category);
    INFO(read.size->transpose());
    CHECK(read.size->isApprox(one.size));
    CHECK(read.quantity == one.quantity);
    CHECK(read.mount == one.mount);
    CHECK(!reply.repairs.empty() == one.repaired);
  }
}

TEST_CASE("What stands on others is told by their name") {
  const PlanReply reply =
      read(with_object(R"({"name": "vase", "place": "on the writing desk"}, {"name": "desk"})"));
  const PlanItem& vase = item(reply.plan, "vase");
  CHECK(vase.mount == Mount::surface);
  CHECK(to_text(vase.relations) == "on, desk-0");
  CHECK(reply.plan.items.front().category == "desk");
}

TEST_CASE("Plans are bounded") {
  std::string many;
  for (int i = 0; i < 100; ++i)
    many += std::string(i ? "," : "") + R"({"name": "chair", "quantity": 9})";
  const PlanReply reply = read(with_object(many));
  CHECK(reply.plan.items.size() <= 60);
  CHECK(planned_objects(reply.plan).size() == 200);
  CHECK(!reply.repairs.empty());
}

TEST_CASE("A plan without objects is an error") {
  for (const char* text : {"", "{}", R"({"room": {"size_m": [4, 3]}})", R"({"objects": []})",
                           R"({"objects": [{}, 3, null]})"}) {
    INFO(text);
    const auto reply = reply_to({"a bedroom", 1, {}, {}, {}}, text);
    REQUIRE(!reply);
    CHECK(reply.error().kind == Error::Kind::invalid_input);
  }
}

TEST_CASE("Damaged plans do no harm") {
  Random random(6);
  int understood = 0;
  for (int i = 0; i < 500; ++i) {
    const std::string text = damaged(good, random, 12, 50);
    INFO(text);
    const auto reply = reply_to({"a room", 1, {}, {}, {}}, text);
    if (!reply) continue;
    ++understood;
    REQUIRE(check(reply->plan.room));
    REQUIRE(!reply->plan.items.empty());
    REQUIRE(planned_objects(reply->plan).size() <= 200);
    for (const auto& one : reply->plan.items) {
      REQUIRE(!one.category.empty());
      REQUIRE(one.size->allFinite());
      REQUIRE(one.size->minCoeff() >= 0.02);
      REQUIRE(one.size->maxCoeff() <= 10.0);
    }
  }
  CHECK(understood > 300);
}

namespace {

std::string whole_room(const std::string& groups, const std::string& more = "") {
  return R"({"concept": "calm", "room": {"type": "dining room", "size_m": [5, 4], "height_m": 2.7,
    "materials": {"floor": "oak floor", "ceiling": "white", "walls": [{"wall": null, "finish": "sage green", "lower": null},
      {"wall": "north", "finish": "red brick", "lower": {"finish": "white panelling", "height": 0.9}}]},
    "light": {"hour": 20, "sky": null, "level": "dim", "warmth": null, "lamps": null}, "style": ["rustic"], "palette": {"main": null}},
    "openings": [{"kind": "door", "wall": "east", "at": 0.2, "width": 0.9, "sill": null, "head": null, "for": "hall"},
      {"kind": "window", "wall": "south", "at": 0.5, "width": 1.6, "sill": 0.8, "head": 2.2, "for": null}],
    "objects": [{"name": "mirror", "description": "round mirror", "size_cm": [60, 4, 60], "quantity": 1, "place": "wall", "bottom_m": 1.2},
      {"name": "picture", "description": "large picture", "size_cm": [90, 3, 120], "quantity": 1, "place": "floor", "lean_deg": 8}],
    "groups": )" + groups + more + "}";
}

PlanReply read_whole(const std::string& groups) { return read(whole_room(groups), {"a dining room", 1, {}, {}, {}}); }

int count_of_part(const Plan& plan, const std::string& part) {
  int count = 0;
  for (const auto& one : plan.items)
    if (one.part == part) count += one.quantity;
  return count;
}

}  // namespace

TEST_CASE("A whole room is read: surfaces, light, openings, heights and a group by composition") {
  const PlanReply reply = read_whole(R"([{"id": "dining", "composition": "dining table", "with": [{"name": "seats", "value": 4}],
    "without": ["rug", "lamp"], "things": [{"part": "chair", "name": "chair", "description": "black chair", "size_cm": null, "quantity": 4}]}])");
  const Room& room = reply.plan.room;
  CHECK(reply.concept_text == "calm");
  CHECK(room.materials.walls == "sage green");
  CHECK(finish_named(room.materials, "north") == "red brick");
  CHECK(room.light.hour == 20.0);
  REQUIRE(room.openings.size() == 2);
  CHECK(std::count_if(room.openings.begin(), room.openings.end(), [](const Opening& one) { return one.is_entrance(); }) == 1);
  CHECK(item(reply.plan, "mirror").bottom == Approx(1.2));
  CHECK(item(reply.plan, "picture").tilt.x() == Approx(-radians(8.0)));
  REQUIRE(reply.plan.groups.size() == 1);
  CHECK(count_of_part(reply.plan, "chair") == 4);
  CHECK(count_of_part(reply.plan, "rug") + count_of_part(reply.plan, "lamp") == 0);
  for (const auto& one : reply.plan.items)
    if (one.part == "chair") CHECK(one.description == "black chair");
}

TEST_CASE("A group of an answer's own says where each thing is, and a composition may be repeated and added to") {
  const Plan own = read_whole(R"([{"id": "hall", "composition": null, "things": [
    {"part": "bench", "name": "bench", "size_cm": [120, 40, 45], "where": null},
    {"part": "glass", "name": "mirror", "size_cm": [80, 4, 80], "where": "above the bench"},
    {"part": "seat", "name": "stool", "quantity": 2, "where": "on both sides of bench", "facing": "to"}]}])").plan;
  REQUIRE(own.groups.size() == 1);
  CHECK(count_of_part(own, "glass") == 1);
  CHECK(count_of_part(own, "seat") == 2);
  const Plan rows = read_whole(R"([{"id": "tables", "composition": "cafe table", "with": [], "repeat": {"rows": 2, "columns": 2},
    "things": [{"part": "screen", "name": "room divider", "where": "behind table"}]}])").plan;
  REQUIRE(rows.groups.size() == 1);
  CHECK(count_of_part(rows, "unit/table") == 4);
  CHECK(count_of_part(rows, "screen") == 4);
}

TEST_CASE("At a place within the outline of a table is on it, but for rugs and seats") {
  const Plan plan = read_whole(R"([{"id": "map", "composition": null, "things": [
    {"part": "table", "name": "dining table", "size_cm": [180, 90, 76], "where": null},
    {"part": "chart", "name": "nautical chart", "size_cm": [110, 70, 4], "where": "at table", "at_m": [0, 0]},
    {"part": "plant", "name": "plant", "where": "at table", "at_m": [1.3, 0]},
    {"part": "rug", "name": "rug", "where": "at table", "at_m": [0, 0]}]}])").plan;
  const auto carried = [&](const std::string& part) {
    const auto parts = Json::parse(plan.groups.at(0).definition)["parts"];
    for (const auto& one : parts)
      if (one["part"] == part) return one.contains("on");
    FAIL(part + " is not there");
    return false;
  };
  CHECK(carried("chart"));
  CHECK_FALSE(carried("plant"));
  CHECK_FALSE(carried("rug"));
}

TEST_CASE("What a group cannot be is told by its name, and its things stand for themselves") {
  for (const char* groups :
       {R"([{"id": "a", "composition": "flying carpet", "things": [{"part": "x", "name": "sofa", "where": null}, {"part": "y", "name": "rug", "where": "beyond x"}]}])",
        R"([{"id": "a", "composition": "dining table", "with": [{"name": "wings", "value": 2}, {"name": "seats", "value": 400}], "things": []}])",
        R"([{"id": "a", "composition": "dining table", "without": ["engine"], "things": [{"part": "engine", "name": "engine"}]}])"}) {
    const PlanReply reply = read_whole(groups);
    CHECK(std::any_of(reply.repairs.begin(), reply.repairs.end(),
                      [](const std::string& repair) { return repair.starts_with("group \"a-0\""); }));
    for (const auto& one : reply.plan.items) CHECK(one.quantity >= 1);
  }
  for (const char* groups : {"7", "[null, 3]", R"([{"things": {"part": "anchor"}}])", R"([{"composition": [], "with": 4, "repeat": {"rows": 1e9}}])"})
    CHECK(read_whole(groups).plan.items.size() >= 2);
}

TEST_CASE("What cannot be read of half a plan is told in words, once and with its place") {
  const std::pair<const char*, const char*> halves[] = {
      {R"("room": {"type": "den", "size_m": [5, 4], "materials": {"floor": 7, "walls": [{"finish": ["x"]}]}})",
       "the room, materials, floor: "},
      {R"("room": {"type": "den", "light": {"hour": "late", "sky": "green"}})", "the room, light, "},
      {R"("room": {"type": "den", "palette": {"main": "blurple"}})", ""},
      {R"("openings": [{"kind": "door", "wall": "east"}, {"kind": "skylight", "wall": "ceiling"}])",
       "opening 2 (skylight), kind: \"skylight\" is no kind of opening"},
      {R"("openings": [{"kind": "door", "wall": "east", "at": 0.5, "width": 0.9},
                       {"kind": "door", "wall": "east", "at": 0.5, "width": 0.9}, 3, {"wall": ""}])", "opening "},
      {R"("groups": [{"id": "", "things": [{"name": "sofa"}, {"part": "y", "where": "on before S"},
                      {"name": "rug", "where": "around "}, {"quantity": -4}, null]}, null, {}, {"composition": "zz"}])",
       "group \"group-0\""},
      {R"("groups": {"things": 4}, "excluded": [null, "", 3, "tv"])", ""},
      {R"("furniture": {"bed_1": {"dims": "2m by 1.6m"}, "": {"count": "many"}, "chair": "four"})", ""}};
  for (const auto& [half, told] : halves) {
    INFO(half);
    const auto reply =
        reply_to({"a den", 1, {}, {}, {}}, "{" + std::string(half) + R"(, "objects": [{"name": "bed", "size_cm": [1, "wide"]}]})");
    REQUIRE(reply);
    REQUIRE(check(reply->plan.room));
    int times = 0;
    for (const auto& note : reply->repairs) {
      INFO(note);
      times += *told && note.starts_with(told);
      for (const char* raw : {"/0", ": :", "  ", "\"\"", "null", " 's", "the  "}) {
        INFO(raw);
        CHECK(note.find(raw) == std::string::npos);
      }
      CHECK(std::count(reply->repairs.begin(), reply->repairs.end(), note) == 1);
    }
    CHECK((!*told || times > 0));
  }
}

TEST_CASE("Compositions are told that suit the things of a wish, and few") {
  const auto lines = [](const std::string& wish) {
    const Brief brief = read_prompt(wish, *built_in_room_kinds(), KindTable::built_in());
    return composition_lines(brief.type, brief, wish);
  };
  const std::string salon = lines("a hair salon with three barber chairs facing mirrors"),
                    engine = lines("an airship engine room with a copper boiler and a hammock"),
                    dining = lines("a dining room with a table for six");
  for (const auto& told : {salon, engine, dining}) CHECK(told.size() < 4000);
  CHECK(salon.find("styling station") < salon.find("Others, by name"));
  CHECK(dining.find("dining table") < dining.find("Others, by name"));
  CHECK(engine.find("pupils") == std::string::npos);
}
