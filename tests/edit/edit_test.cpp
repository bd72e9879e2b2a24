// Edits of furnished rooms: what nobody named stays, nothing invalid comes in, undo gives everything back.
#include <nlohmann/json.hpp>
#include <set>

#include "base/random.h"
#include "catch.h"
#include "roomgen/base/file.h"
#include "roomgen/create/create.h"
#include "roomgen/design/designer.h"
#include "roomgen/evaluate/report.h"
#include "roomgen/generate/generate.h"
#include "roomgen/edit/session.h"
#include "support/rooms.h"
#include "support/temporary_folder.h"

using namespace roomgen;

namespace {

const AssetLibrary& things_from_words() {
  static const auto library = create::make_finishing_library(create::make_created_library());
  return *library;
}

std::string furnished(const std::string& prompt, std::uint64_t seed) {
  const auto designer = make_rule_designer();
  PlanRequest request;
  request.prompt = prompt;
  request.seed = seed;
  const auto plan = designer->plan(request);
  REQUIRE(plan);
  const auto room = generate(*plan, *designer, things_from_words(), KindTable::built_in());
  REQUIRE(room);
  return dump_json(to_json(room->scene));
}

Session open(const std::filesystem::path& file) {
  auto session = Session::open(file, things_from_words(), KindTable::built_in());
  INFO((session ? "" : session.error().message));
  REQUIRE(session);
  return *std::move(session);
}

Session open_with(const TemporaryFolder& folder, const std::string& text) {
  REQUIRE(write_file(folder / "scene.json", text));
  return open(folder / "scene.json");
}

edit::Operation random_operation(const Scene& scene, Random& random) {
  const auto& one = random.pick(scene.objects);
  const auto& other = random.pick(scene.objects);
  const char* kinds[] = {"armchair", "floor lamp", "plant", "stool", "side table", "bookshelf", "basket"};
  const RelationKind places[] = {RelationKind::near, RelationKind::next_to, RelationKind::left_of, RelationKind::in_front_of};
  const Relation place{places[random.integer(0, 3)], other.id};
  const std::string wall = "wall-" + std::to_string(random.integer(0, static_cast<int>(scene.room.polygon.size()) - 1));
  const std::string opening = random.pick(scene.room.openings).id;
  switch (random.integer(0, 17)) {
    case 0: return edit::Add{kinds[random.integer(0, 6)], ""};
    case 1: return edit::Add{kinds[random.integer(0, 6)], "", {}, 1, {place}};
    case 2: return edit::Remove{{one.id}};
    case 3: return edit::Move{one.id, {place}};
    case 4: return edit::Move{one.id, {{RelationKind::edge, ""}}};
    case 5: return edit::Shift{one.id, {random.uniform(-1, 1), random.uniform(-1, 1), 0.0}};
    case 6: return edit::Turn{one.id, 0.5 * pi * random.integer(1, 3)};
    case 7: return edit::Face{one.id, other.id};
    case 8: return edit::Swap{one.id, other.id};
    case 9: return edit::Resize{one.id, one.size * random.uniform(0.8, 1.2)};
    case 10: return edit::Move{one.id, {place}, true};
    case 11: return edit::Shift{one.id, {random.uniform(-1, 1), random.uniform(-1, 1), 0.0}, true};
    case 12: return edit::Rearrange{{one.id}};
    case 13: return edit::Reshape{wall, random.uniform(-0.8, 0.8)};
    case 14: return edit::Open{random.chance(0.5) ? "window" : "door", wall};
    case 15: return edit::Refit{opening, wall};
    case 16: return scene.room.openings.size() > 1 ? edit::Operation(edit::Close{{opening}}) : edit::Reshape{"", 0.0, 2.9};
    default: return edit::Replace{one.id};
  }
}

// The group of which a thing is the first.
std::set<std::string> led_by(const Scene& scene, const std::string& id) {
  const Object* leader = find_object(scene, id);
  std::vector<std::string> group;
  if (leader && !leader->group.empty())
    for (const auto& object : scene.objects)
      if (object.group == leader->group) group.push_back(object.id);
  if (group.empty() || group.front() != id) return {};
  return {group.begin(), group.end()};
}

// What stands around a thing.
std::set<std::string> around(const Scene& scene, const std::string& id) {
  std::set<std::string> ids;
  for (const auto& object : scene.objects)
    for (const auto kind : {RelationKind::around, RelationKind::face_to})
      if (std::count(object.relations.begin(), object.relations.end(), Relation{kind, id})) ids.insert(object.id);
  for (const auto& one : led_by(scene, id))
    if (one != id && find_object(scene, one)->on.empty()) ids.insert(one);
  return ids;
}

// Whatever stands to it, or to what stands to it: what is set out anew with it.
std::set<std::string> related(const Scene& scene, const std::string& id) {
  std::set<std::string> ids = {id};
  for (std::size_t before = 0; before != ids.size();) {
    before = ids.size();
    for (const auto& object : scene.objects)
      for (const auto& relation : object.relations)
        if (relation.kind != RelationKind::far && find_object(scene, relation.target) &&
            (ids.count(object.id) || ids.count(relation.target)))
          ids.insert({object.id, relation.target});
  }
  return ids;
}

std::set<std::string> named_in(const Scene& scene, const edit::Operation& operation) {
  std::set<std::string> ids;
  std::visit(
      [&](const auto& one) {
        using T = std::decay_t<decltype(one)>;
        if constexpr (requires { one.object; }) ids.insert(one.object);
        if constexpr (requires { one.objects; }) ids.insert(one.objects.begin(), one.objects.end());
        bool is_group = false;
        if constexpr (requires { one.group; }) is_group = one.group;
        if (is_group) ids.merge(around(scene, *ids.begin()));
        if (std::is_same_v<T, edit::Rearrange>) {
          const Object* one = find_object(scene, *ids.begin());
          for (const auto& object : scene.objects)
            if (one && !one->group.empty() && object.group == one->group) ids.insert(object.id);
          if (ids.size() == 1) ids = related(scene, *ids.begin());
        }
        if constexpr (std::is_same_v<T, edit::Swap>) ids = {one.first, one.second};
        for (const auto& id : std::set<std::string>(ids)) ids.merge(led_by(scene, id));
      },
      operation);
  return ids;
}

// With all that stands on them.
std::set<std::string> with_loads(const Scene& scene, std::set<std::string> ids) {
  for (std::size_t before = 0; before != ids.size();) {
    before = ids.size();
    for (const auto& object : scene.objects)
      if (ids.count(object.on)) ids.insert(object.id);
  }
  return ids;
}

bool has_rug(const Scene& scene, const std::set<std::string>& ids) {
  return std::any_of(ids.begin(), ids.end(), [&](const std::string& id) {
    const Object* object = find_object(scene, id);
    return object && object->traits.flat;
  });
}

std::set<std::string> faults(const Scene& scene, const ModelTable& models) {
  std::set<std::string> all;
  for (const auto& violation : examine(scene, models, KindTable::built_in()).violations)
    all.insert(std::string(name(violation.fault)) + " " + violation.object + " " + violation.other);
  return all;
}

void check_untouched(const Scene& before, const Scene& after, const edit::Operation& operation, const EditReport& report) {
  auto touched = named_in(before, operation);
  for (const auto& move : report.repairs) {
    touched.insert(move.object);
    touched.merge(led_by(before, move.object));
  }
  touched = with_loads(before, touched);
  // What stands on a rug keeps its place, but not its height.
  const bool may_rise = has_rug(before, touched);
  const bool closes = std::holds_alternative<edit::Close>(operation);
  for (const auto& object : before.objects) {
    const bool goes_with_window = closes && KindTable::built_in().get(object.category).covers_window;
    if (touched.count(object.id) || goes_with_window) continue;
    INFO(object.id);
    const Object* now = find_object(after, object.id);
    REQUIRE(now);
    CHECK(now->position.x() == object.position.x());
    CHECK(now->position.y() == object.position.y());
    CHECK((may_rise || now->position.z() == object.position.z()));
    CHECK(now->yaw == object.yaw);
    CHECK(now->size == object.size);
    CHECK(now->asset == object.asset);
  }
}

}  // namespace

TEST_CASE("200 edits of furnished rooms leave everything else alone and valid, and undo gives the first bytes") {
  const char* prompts[] = {"a bedroom with a desk, two nightstands and a rug", "a living room with a sofa, two armchairs and a coffee table",
                           "a dining room with a table and six chairs", "a study with a desk, a bookshelf and an armchair"};
  int done = 0, refused = 0;
  for (int room = 0; room < 4; ++room) {
    const TemporaryFolder folder;
    const std::string first = furnished(prompts[room], 3);
    auto session = open_with(folder, first);
    Random random(static_cast<std::uint64_t>(room));
    for (int step = 0; step < 50; ++step) {
      const Scene before = session.scene();
      const auto fault_before = faults(before, session.models());
      const edit::Operation operation = random_operation(before, random);
      INFO(edit::to_json(operation).dump());
      const auto report = session.apply({&operation, 1});
      if (!report) {
        ++refused;
        CHECK(!report.error().message.empty());
        CHECK(dump_json(to_json(session.scene())) == dump_json(to_json(before)));
        continue;
      }
      ++done;
      check_untouched(before, session.scene(), operation, *report);
      for (const auto& fault : faults(session.scene(), session.models())) {
        INFO(fault);
        CHECK(fault_before.count(fault) == 1);
      }
    }
    REQUIRE(session.undo(1000));
    CHECK(session.text() == first);
    REQUIRE(session.save());
    CHECK(*read_file(folder / "scene.json") == first);
    REQUIRE(session.redo(1000));
  }
  INFO(done << " done, " << refused << " refused");
  CHECK(done >= 100);
}

TEST_CASE("What stands on a thing moves with it, and goes with it") {
  const TemporaryFolder folder;
  auto session = open_with(folder, furnished("a bedroom with a bed and a desk with a lamp on it", 1));
  const auto lamp_on = [&]() -> const Object* {
    for (const auto& object : session.scene().objects)
      if (object.on == "desk-0") return &object;
    return nullptr;
  };
  REQUIRE(lamp_on());
  const std::string lamp = lamp_on()->id;
  const Vec3 gap = lamp_on()->position - find_object(session.scene(), "desk-0")->position;
  const edit::Operation lock = edit::Lock{{lamp}}, move = edit::Move{"desk-0", {{RelationKind::middle, ""}}};
  REQUIRE(session.apply({&move, 1}));
  const Object& desk = *find_object(session.scene(), "desk-0");
  const Vec3 now = find_object(session.scene(), lamp)->position - desk.position;
  CHECK(now.norm() == Approx(gap.norm()).margin(1e-3));
  const edit::Operation remove = edit::Remove{{"desk-0"}};
  REQUIRE(session.apply({&lock, 1}));
  CHECK(!session.apply({&remove, 1}));
  const edit::Operation unlock = edit::Lock{{lamp}, false};
  REQUIRE(session.apply({&unlock, 1}));
  REQUIRE(session.apply({&remove, 1}));
  CHECK(!find_object(session.scene(), lamp));
  for (const auto& verdict : session.scene().requirements)
    if (verdict.requirement.category == "desk") CHECK(verdict.compliance == Compliance::withdrawn);
}

TEST_CASE("Neighbours make way where there is no room, and only if they may") {
  // A box in the middle of each wall: nothing 1.6 m long stands at a wall unless one of them moves.
  Room room = rooms::box(3.2, 3.2);
  room.openings = {rooms::door("door-0", 0, 0.1, 0.9)};
  Scene scene = rooms::scene(room, {rooms::thing("storage box-0", "storage box", {0.4, 0.4, 0.4}, {1.6, 0.2}),
                                    rooms::thing("storage box-1", "storage box", {0.4, 0.4, 0.4}, {3.0, 1.6}),
                                    rooms::thing("storage box-2", "storage box", {0.4, 0.4, 0.4}, {1.6, 3.0}),
                                    rooms::thing("storage box-3", "storage box", {0.4, 0.4, 0.4}, {0.2, 1.6})});
  const std::string text = dump_json(to_json(scene));
  const edit::Operation add = edit::Add{"sideboard", "sideboard", Vec3(1.6, 0.45, 0.8), 1, {{RelationKind::edge, ""}}};
  const TemporaryFolder folder;
  {
    auto session = open_with(folder, text);
    const auto report = session.apply({&add, 1});
    INFO((report ? "" : report.error().message));
    REQUIRE(report);
    CHECK(report->repairs.size() == 1);
    CHECK(faults(session.scene(), session.models()).empty());
  }
  const TemporaryFolder other;
  REQUIRE(write_file(other / "scene.json", text));
  SessionOptions options;
  options.repair = false;
  auto session = Session::open(other / "scene.json", things_from_words(), KindTable::built_in(), options);
  REQUIRE(session);
  const auto refused = session->apply({&add, 1});
  REQUIRE(!refused);
  CHECK(refused.error().message.find("removing storage box-") != std::string::npos);
  CHECK(session->text() == text);
}

TEST_CASE("The ledger follows an edit") {
  const TemporaryFolder folder;
  auto session = open_with(folder, furnished("a living room with a sofa, two armchairs and no television", 2));
  const auto compliance_of = [&](const std::string& clause) {
    for (const auto& verdict : session.scene().requirements)
      if (verdict.requirement.clause.find(clause) != std::string::npos) return verdict.compliance;
    return Compliance::not_judged;
  };
  REQUIRE(compliance_of("armchair") == Compliance::met);
  const edit::Operation remove = edit::Remove{{"armchair-0"}};
  REQUIRE(session.apply({&remove, 1}));
  CHECK(compliance_of("2 armchair") == Compliance::withdrawn);
  CHECK(compliance_of("1 armchair") == Compliance::met);
  const edit::Operation add = edit::Add{"plant", "plant", {}, 1, {{RelationKind::near, "sofa-0"}}};
  REQUIRE(session.apply({&add, 1}));
  const auto& last = session.scene().requirements.back();
  CHECK(last.requirement.source == Requirement::Source::edit);
  CHECK(last.met());
}

TEST_CASE("What went and comes again is asked for as before") {
  const TemporaryFolder folder;
  for (const bool both : {true, false}) {
    auto session = open_with(folder, furnished("a living room with a sofa and two armchairs", 2));
    const auto before = session.scene().requirements;
    const auto apply = [&](const edit::Operation& operation) { REQUIRE(session.apply({&operation, 1})); };
    apply(both ? edit::Remove{{"armchair-0", "armchair-1"}} : edit::Remove{{"armchair-1"}});
    apply(edit::Add{"armchair", "armchair", {}, both ? 2 : 1});
    for (const auto& old : before)
      for (const auto& now : session.scene().requirements)
        if (now.requirement.id == old.requirement.id) {
          INFO(old.requirement.clause);
          CHECK(now.compliance == old.compliance);
        }
    session.undo(2);
    CHECK(session.scene().requirements.size() == before.size());
    std::filesystem::remove(folder / "scene.journal");
  }
}

namespace {

// A post of 0.3 m on a foot, and a ball that floats over it.
const char* const drawn_toad = R"({"components": [
    {"name": "foot", "box": {"size": [0.2, 0.2, 0.1]}, "material": "green"},
    {"name": "post", "box": {"size": [0.1, 0.1, 0.3]}, "at": [0, 0, 0.1], "material": "green"},
    {"name": "eye", "ellipsoid": {"size": [0.06, 0.06, 0.06]}, "at": [0, 0, 0.45], "material": "gold"}]})";

}  // namespace

TEST_CASE("What is drawn for a room comes as drawn, stands on things, and its like comes by its name") {
  TemporaryFolder folder;
  Session session = open_with(folder, furnished("a study with a desk", 1));
  edit::Add toad{"toad", "fat green toad", {}, 1, {{RelationKind::on, "desk-0"}}};
  toad.program = drawn_toad;
  const auto report = session.apply({{toad}});
  INFO((report ? "" : report.error().message));
  REQUIRE(report);
  REQUIRE(report->added == std::vector<std::string>{"toad-0"});
  CHECK(std::any_of(report->changes.begin(), report->changes.end(),
                    [](const std::string& one) { return one.find("loose: eye") != std::string::npos; }));
  const Object first = *find_object(session.scene(), "toad-0");
  CHECK(first.on == "desk-0");
  CHECK(first.size.isApprox(Vec3(0.2, 0.2, 0.51), 1e-3));
  REQUIRE(session.apply({{edit::Add{"toad", "another toad"}}}));
  CHECK(find_object(session.scene(), "toad-1")->asset == first.asset);

  edit::Replace other{"toad-1", "frog king", "a frog king"};
  other.program = drawn_toad;
  const auto replaced = session.apply({{other}});
  INFO((replaced ? "" : replaced.error().message));
  REQUIRE(replaced);
  CHECK(find_object(session.scene(), "frog king-0")->asset.procedural->recipe == "program");

  toad.program = R"({"components": [{"name": "a", "box": {"size": [1]}}]})";
  const auto broken = session.apply({{toad}});
  REQUIRE(!broken);
  CHECK(broken.error().message.find("/components/0") != std::string::npos);
}

TEST_CASE("What is to hang from a thing comes to hang under it, and stays under it") {
  TemporaryFolder folder;
  Object rail = rooms::thing("rail-0", "rail", {2.0, 0.1, 0.1}, {2.0, 2.0});
  rail.mount = Mount::ceiling;
  rail.position.z() = 2.0;
  const auto table = rooms::thing("coffee table-0", "coffee table", {0.9, 0.5, 0.45}, {1.0, 3.3});
  Session session = open_with(folder, dump_json(to_json(rooms::scene(rooms::box(4, 4), {rail, table}))));
  const auto apply = [&](const edit::Operation& operation) {
    const auto report = session.apply({&operation, 1});
    INFO((report ? "" : report.error().message));
    return report.ok();
  };
  edit::Add toad{"toad", "green toad", {}, 2, {{RelationKind::hang_from, "rail-0"}}};
  toad.program = drawn_toad;
  REQUIRE(apply(toad));
  toad.count = 1;
  toad.relations = {{RelationKind::on, "coffee table-0"}};
  REQUIRE(apply(toad));
  REQUIRE(apply(edit::Move{"toad-2", {{RelationKind::hang_from, "rail-0"}}}));
  for (const char* id : {"toad-0", "toad-1", "toad-2"}) {
    const Object& hung = *find_object(session.scene(), id);
    CHECK(top(hung) == Approx(2.0).margin(0.01));
    CHECK(gap(footprint(rail), footprint(hung)) < 0.15);
    CHECK(hung.on.empty());
  }
  CHECK_FALSE(apply(edit::Put{"toad-0", Vec2(3.0, 3.0)}));
  for (const auto& verdict : session.scene().requirements) CHECK(verdict.compliance != Compliance::not_met);
}

TEST_CASE("What is put from one top onto another comes to the height of that") {
  TemporaryFolder folder;
  Session session = open_with(
      folder, dump_json(to_json(rooms::scene(
                  rooms::box(4, 4), {rooms::thing("sideboard-0", "sideboard", {1.2, 0.45, 0.8}, {1.0, 3.7}),
                                     rooms::thing("coffee table-0", "coffee table", {0.9, 0.5, 0.45}, {3.0, 1.5})}))));
  edit::Add toad{"toad", "green toad", {}, 1, {{RelationKind::on, "sideboard-0"}}};
  toad.program = drawn_toad;
  REQUIRE(session.apply({{toad}}));
  const auto put = session.apply({{edit::Put{"toad-0", Vec2(3.1, 1.5)}}});
  INFO((put ? "" : put.error().message));
  REQUIRE(put);
  const Object& there = *find_object(session.scene(), "toad-0");
  CHECK(there.on == "coffee table-0");
  CHECK(bottom(there) == Approx(0.45).margin(0.01));
}

TEST_CASE("What covers a window may go and become another, and stays in its place") {
  TemporaryFolder folder;
  Session session = open_with(folder, furnished("a bedroom with a bed and a roller blind", 1));
  const Object blind = *find_object(session.scene(), "roller blind-0");
  REQUIRE(blind.locked);
  CHECK_FALSE(session.apply({{edit::Shift{blind.id, Vec3(0.2, 0, 0)}}}));
  CHECK(session.apply({{edit::Recolor{blind.id, "navy"}}}));
  CHECK(find_object(session.scene(), blind.id)->locked);
  REQUIRE(session.apply({{edit::Remove{{blind.id}}}}));
}

TEST_CASE("What is exchanged is asked for as the one before, and counted once") {
  TemporaryFolder folder;
  auto scene = scene_from_json(*parse_json(furnished("a study with a desk", 1), "scene"), "scene");
  REQUIRE(scene);
  Session session = open_with(folder, dump_json(to_json(*scene)));
  REQUIRE(session.apply({{edit::Add{"stool", "oak stool", {}, 3}}}));
  scene = session.scene();
  const std::vector<std::string> stools = {"stool-0", "stool-1", "stool-2"};
  Requirement number{"r90", Requirement::Kind::count, Requirement::Source::prompt, "3 stools", "stool"};
  number.count = 3;
  Requirement near{"r91", Requirement::Kind::relation, Requirement::Source::prompt, "stools near the desk", "stool"};
  near.relation = RelationKind::near;
  near.targets = {"desk-0"};
  number.subjects = near.subjects = stools;
  std::erase_if(scene->requirements, [](const auto& one) { return one.requirement.category == "stool"; });
  scene->requirements.push_back({number, Compliance::met, ""});
  scene->requirements.push_back({near, Compliance::not_met, ""});
  std::filesystem::remove(folder / "scene.journal");
  Session exchanged = open_with(folder, dump_json(to_json(*scene)));
  for (const auto& id : stools) {
    const std::vector<edit::Operation> both = {edit::Remove{{id}}, edit::Add{"stool", "pine stool"}};
    REQUIRE(exchanged.apply(both));
  }
  CHECK(exchanged.scene().requirements.size() == scene->requirements.size());
  for (const auto& verdict : exchanged.scene().requirements) {
    if (verdict.requirement.category != "stool") continue;
    CHECK(verdict.requirement.subjects == std::vector<std::string>{"stool-3", "stool-4", "stool-5"});
    CHECK(verdict.compliance != Compliance::withdrawn);
  }
  // Of fewer the rest is asked as before, and the number is the new one.
  const std::vector<edit::Operation> fewer = {edit::Remove{{"stool-3", "stool-4", "stool-5"}},
                                              edit::Add{"stool", "elm stool", {}, 2}};
  REQUIRE(exchanged.apply(fewer));
  for (const auto& verdict : exchanged.scene().requirements) {
    if (verdict.requirement.id == "r90") CHECK(verdict.compliance == Compliance::withdrawn);
    if (verdict.requirement.id == "r91") CHECK(verdict.requirement.subjects.size() == 2);
    if (verdict.requirement.id == "r91") CHECK(verdict.compliance != Compliance::withdrawn);
  }
  CHECK(exchanged.scene().requirements.back().requirement.count == 2);
}

TEST_CASE("A new thing is counted for what was asked for and found no place") {
  TemporaryFolder folder;
  auto scene = scene_from_json(*parse_json(furnished("a study with a desk", 1), "scene"), "scene");
  REQUIRE(scene);
  Requirement asked{"r90", Requirement::Kind::count, Requirement::Source::prompt, "2 stools", "stool"};
  asked.count = 2;
  asked.subjects = {"stool-0", "stool-1"};
  scene->requirements.push_back({asked, Compliance::not_met, "stool-0 was left out: no room"});
  for (const char* id : {"stool-0", "stool-1"}) scene->unplaced.push_back({id, "stool", "no room"});
  Session session = open_with(folder, dump_json(to_json(*scene)));
  const auto verdict = [&] {
    for (const auto& one : session.scene().requirements)
      if (one.requirement.id == "r90") return one;
    return RequirementVerdict{};
  };
  REQUIRE(session.apply({{edit::Add{"stool", "oak stool"}}}));
  CHECK(!verdict().met());
  CHECK(session.scene().unplaced.size() == 1);
  REQUIRE(session.apply({{edit::Add{"stool", "oak stool"}}}));
  CHECK(verdict().met());
  CHECK(session.scene().unplaced.empty());
  // Of more than were asked for some may go.
  REQUIRE(session.apply({{edit::Add{"stool", "oak stool", {}, 2}}}));
  REQUIRE(session.apply({{edit::Remove{{"stool-4", "stool-5"}}}}));
  CHECK(verdict().met());
}

TEST_CASE("The light of a room is what was said last, the rest as before") {
  const TemporaryFolder folder;
  auto session = open_with(folder, furnished("a bedroom with a bed and a table lamp", 1));
  const auto asked = [&](const char* text) {
    const auto read = edit::operations_from_json(*parse_json(text, "op"), "op");
    return read ? session.apply(*read) : Result<EditReport>(read.error());
  };
  REQUIRE(asked(R"({"do": "light", "hour": 20.5, "level": "dim", "lamps": ["table lamp"]})"));
  const auto report = asked(R"({"do": "light", "warmth": 2400})");
  REQUIRE(report);
  CHECK(report->changes.size() == 1);
  const Lighting& light = session.scene().room.light;
  CHECK(light.hour == 20.5);
  CHECK(light.kelvin == 2400.0);
  CHECK(light.lux < 100.0);
  REQUIRE(light.lamps);
  CHECK(light.lamps->front() == "table lamp");
  for (const char* wrong : {R"({"do": "light"})", R"({"do": "light", "level": "blinding"})", R"({"do": "light", "hour": 25})",
                            R"({"do": "light", "lamps": ["sun-7"]})"})
    CHECK_FALSE(asked(wrong));
  CHECK(session.scene().room.light == light);
  for (const char* looks : {"navy", "sage green"}) {
    const auto covered = asked((R"({"do": "cover", "part": "wall-2", "looks": ")" + std::string(looks) + "\"}").c_str());
    REQUIRE(covered);
    CHECK(covered->changes.front().find(looks) != std::string::npos);
    CHECK(cover_of(session.scene().room, 2).finish == std::string(looks) + " wall");
  }
  CHECK(cover_of(session.scene().room, 1).finish.find("green") == std::string::npos);
  CHECK_FALSE(asked(R"({"do": "cover", "part": "wall-9", "looks": "navy"})"));
}

TEST_CASE("A preview says what a pose would mean and changes nothing") {
  const TemporaryFolder folder;
  auto session = open_with(folder, furnished("a bedroom with a bed and a desk", 1));
  const std::string text = session.text();
  const Object bed = *find_object(session.scene(), session.scene().objects.front().id);
  const auto there = session.preview(bed.id, {bed.position.head<2>(), bed.yaw});
  REQUIRE(there);
  CHECK(there->feasible);
  CHECK(there->broken.empty());
  const auto outside = session.preview(bed.id, {{100.0, 100.0}, 0.0});
  REQUIRE(outside);
  CHECK(!outside->feasible);
  CHECK(!outside->reason.empty());
  CHECK(!session.preview("nothing-7", {}));
  CHECK(session.text() == text);
  CHECK(session.history().size() == 1);
}

TEST_CASE("A second program gets a clear error, and may look") {
  const TemporaryFolder folder;
  auto session = open_with(folder, furnished("a bedroom with a bed", 1));
  const auto second = Session::open(folder / "scene.json", things_from_words(), KindTable::built_in());
  REQUIRE(!second);
  CHECK(second.error().message.find("another program") != std::string::npos);
  SessionOptions look;
  look.look_only = true;
  CHECK(Session::open(folder / "scene.json", things_from_words(), KindTable::built_in(), look));
}

TEST_CASE("Operations survive JSON, and what is none is told with its place") {
  Random random(6);
  Scene scene = *scene_from_json(*parse_json(furnished("a bedroom with a bed and two chairs", 1), "scene"), "scene");
  for (int i = 0; i < 200; ++i) {
    const auto operation = random_operation(scene, random);
    const auto again = edit::operation_from_json(edit::to_json(operation), "op");
    REQUIRE(again);
    CHECK(edit::to_json(*again) == edit::to_json(operation));
  }
  const auto joined = edit::operation_from_json(
      *parse_json(R"({"do": "move", "object": "a", "relations": ["edge | near, b"]})", "op"), "op");
  REQUIRE(joined);
  CHECK(edit::to_json(*joined)["relations"] == Json({"edge", "near, b"}));
  for (const char* text : {R"({"do": "fly"})", R"({"do": "move", "object": 7, "relations": []})", R"([])", R"(3)",
                           R"({"do": "resize", "object": "a", "size": [1, -1, 1]})",
                           R"({"do": "add", "category": "chair", "count": 100000})", R"({"do": "lock", "objects": []})",
                           R"({"do": "move", "object": "a", "relations": ["flying, b"]})", R"({"do": "turn", "object": "a"})"}) {
    const auto bad = edit::operations_from_json(*parse_json(text, "op"), "op");
    REQUIRE(!bad);
    CHECK(bad.error().message.find("op") == 0);
  }
}

TEST_CASE("A group that turns stands as it stood to each other, and all goes back") {
  const TemporaryFolder folder;
  auto session = open_with(folder, furnished("a dining room of 6 x 6 m with a square table and four chairs", 3));
  const Scene before = session.scene();
  const Object* table = find_object(before, "dining table-0");
  REQUIRE(table);
  const auto chairs = around(before, table->id);
  REQUIRE(chairs.size() >= 4);
  int turned = 0;
  for (const double angle : {90.0, 180.0, -90.0, 30.0}) {
    const edit::Operation turn = edit::Turn{table->id, radians(angle), true};
    if (!session.apply({&turn, 1})) continue;  // there is no room for that
    ++turned;
    const Object& there = *find_object(session.scene(), table->id);
    for (const auto& id : chairs) {
      const Object &was = *find_object(before, id), &is = *find_object(session.scene(), id);
      const Vec2 from = was.position.head<2>() - table->position.head<2>();
      const Vec2 to = is.position.head<2>() - there.position.head<2>();
      CAPTURE(id, angle);
      CHECK((rotated(from, radians(angle)) - to).norm() < 1e-3);  // scene.json has millimetres
      CHECK(std::abs(wrap_angle(is.yaw - was.yaw - radians(angle))) < 1e-3);
    }
    REQUIRE(session.undo());
    for (const auto& object : before.objects)
      CHECK(find_object(session.scene(), object.id)->position == object.position);
  }
  CHECK(turned > 0);
}

TEST_CASE("A group that moves is asked for where it went, as a thing alone is") {
  for (const bool group : {false, true}) {
    const TemporaryFolder folder;
    auto session = open_with(folder, furnished("a dining room with a table and four chairs", 3));
    const edit::Operation move = edit::Move{"dining table-0", {{RelationKind::near, "window-0"}}, group};
    const auto report = session.apply({&move, 1});
    INFO((report ? "" : report.error().message));
    REQUIRE(report);
    const auto& ledger = session.scene().requirements;
    CHECK(std::count_if(ledger.begin(), ledger.end(), [](const RequirementVerdict& verdict) {
            return verdict.requirement.source == Requirement::Source::edit && verdict.requirement.relation == RelationKind::near &&
                   verdict.requirement.targets == std::vector<std::string>{"window-0"};
          }) == 1);
  }
}

TEST_CASE("A corner that is set out anew stands to each other as it did, or all stays") {
  const TemporaryFolder folder;
  Session session =
      open_with(folder, furnished("a living room with a sofa, a coffee table, a tv stand with a tv and two armchairs", 3));
  const Scene before = session.scene();
  const auto report = session.apply(std::vector<edit::Operation>{edit::Rearrange{{"sofa-0"}}});
  if (!report) {
    CHECK(report.error().message.find("stand to each other") != std::string::npos);
    CHECK(session.text() == dump_json(to_json(before)));
    return;
  }
  CHECK(report->broken.empty());
  for (const char* id : {"sofa-0", "coffee table-0"})
    CHECK(find_object(session.scene(), id)->position != find_object(before, id)->position);
}

TEST_CASE("An edit that is stopped, or takes too long, changes nothing") {
  const TemporaryFolder folder;
  const std::string text = furnished("a bedroom with a desk", 5);
  REQUIRE(write_file(folder / "scene.json", text));
  SessionOptions hurried, stopped;
  hurried.seconds = 1e-9;
  stopped.cancel.cancel();
  for (const auto& [options, kind] : {std::pair(hurried, Error::Kind::limit), std::pair(stopped, Error::Kind::cancelled)}) {
    auto session = Session::open(folder / "scene.json", things_from_words(), KindTable::built_in(), options);
    REQUIRE(session);
    const std::vector<edit::Operation> operations = {edit::Add{"armchair", ""}};
    const auto report = session->apply(operations, {"add an armchair", "test"});
    REQUIRE(!report);
    CHECK(report.error().kind == kind);
    CHECK(report.error().message.find("nothing is changed") != std::string::npos);
    CHECK(session->history().size() == 1);
  }
  CHECK(*read_file(folder / "scene.json") == text);
}
