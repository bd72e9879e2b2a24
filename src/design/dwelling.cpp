#include "roomgen/design/designer.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/random.h"
#include "brief/dwelling_kinds.h"
#include "brief/prompt.h"
#include "brief/room_kinds.h"
#include "brief/said_wish.h"
#include "plan/coverage.h"
#include "plan/dwelling_layout.h"
#include "plan/dwelling_openings.h"
#include "roomgen/base/text.h"
#include "roomgen/kinds/kind_table.h"
#include "scene/dwelling.h"

namespace roomgen {

namespace {

constexpr double height = 2.6;           // of all rooms: they have one ceiling
// Of what such a room usually has: rooms must lie around each other.
constexpr double least_share = 0.75, greatest_share = 2.0;

double bounded(double area, const brief::DwellingRoom& kind) {
  return std::clamp(area, least_share * kind.area.low, greatest_share * kind.area.high);
}

// A room that dwellings do not usually have is like any other.
brief::DwellingRoom kind_of(const std::string& type, const brief::DwellingKinds& dwellings) {
  const auto known = dwellings.rooms.find(type);
  return known == dwellings.rooms.end() ? brief::DwellingRoom() : known->second;
}

// What the prompt says of the room's size, else drawn by its kind.
double area_of(const brief::Brief& brief, const brief::DwellingRoom& kind,
               const brief::RoomKinds& kinds, Random random) {
  if (brief.size) return bounded(brief.size->prod(), kind);
  if (brief.area) return bounded(*brief.area, kind);
  double area = random.uniform(kind.area.low, kind.area.high);
  for (const auto& word : brief.styles)
    if (const brief::Style* style = kinds.style(word)) area *= style->size * style->size;
  return bounded(area, kind);
}

std::vector<plan::LaidRoom> lay(const brief::SaidDwelling& said,
                                const brief::DwellingKinds& dwellings,
                                const brief::RoomKinds& kinds, const Random& random) {
  std::vector<plan::LaidRoom> rooms;
  double sum = 0.0;
  for (std::size_t i = 0; i < said.rooms.size(); ++i) {
    const double area = area_of(said.rooms[i].brief, kind_of(said.rooms[i].type, dwellings), kinds,
                                random.fork("area " + std::to_string(i)));
    rooms.push_back({said.rooms[i].type, area, said.rooms[i].owner, {}});
    sum += area;
  }
  if (said.area)
    for (auto& room : rooms)
      room.area = bounded(room.area * *said.area / sum, kind_of(room.type, dwellings));
  return plan::lay_out(std::move(rooms), dwellings);
}

std::vector<Room> make_rooms(const std::vector<plan::LaidRoom>& laid, const brief::RoomKinds& kinds,
                             Random random) {
  std::vector<Room> rooms;
  std::map<std::string, int> numbers;
  for (const auto& each : laid) {
    const brief::RoomKind& kind = kinds.get(each.type);
    Room room;
    room.type = each.type;
    room.id = join(words(each.type), "-") + "-" + std::to_string(numbers[each.type]++);
    room.height = height;
    const Vec2 &low = each.box.low, &high = each.box.high;
    room.polygon.points = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
    if (!kind.floors.empty()) room.materials.floor = random.pick(kind.floors);
    if (!kind.walls.empty()) room.materials.walls = random.pick(kind.walls);
    room.materials.ceiling = "white ceiling";
    rooms.push_back(std::move(room));
  }
  return rooms;
}

// One floor runs through a dwelling, but for rooms that get wet.
void share_floors(std::vector<Room>& rooms) {
  const auto is_wooden = [](const Room& room) {
    return room.materials.floor.find("tile") == std::string::npos;
  };
  const auto first = std::find_if(rooms.begin(), rooms.end(), is_wooden);
  if (first == rooms.end()) return;
  const std::string floor = first->materials.floor;
  for (auto& room : rooms)
    if (is_wooden(room)) room.materials.floor = floor;
}

// Ids are unique in the whole dwelling.
void name_requirements(Plan& plan) {
  const std::string prefix = plan.room.id + "/";
  for (auto& requirement : plan.requirements) requirement.id = prefix + requirement.id;
  for (auto& words : plan.heard)
    for (auto& id : words.requirements) id = prefix + id;
}

// How many rooms of each kind the prompt names, and what its words were taken for.
void keep_ledger(const brief::SaidDwelling& said, DwellingPlan& plan) {
  std::map<std::string, std::string> ids;
  for (const auto& room : said.rooms) {
    const bool is_named =
        std::any_of(said.heard.begin(), said.heard.end(),
                    [&](const brief::HeardWords& words) { return words.word == room.type; });
    if (!is_named || ids.count(room.type)) continue;
    Requirement requirement;
    requirement.id = ids[room.type] = "r" + std::to_string(plan.requirements.size() + 1);
    requirement.kind = Requirement::Kind::room;
    requirement.attribute = "rooms";
    requirement.category = room.type;
    requirement.amount = static_cast<double>(
        std::count_if(said.rooms.begin(), said.rooms.end(),
                      [&](const brief::SaidRoom& other) { return other.type == room.type; }));
    requirement.clause = format_number(requirement.amount, 0) + " " + room.type;
    plan.requirements.push_back(std::move(requirement));
  }
  plan.heard = plan::heard_words(plan.prompt, said, plan.rooms, ids);
}

std::optional<brief::SaidDwelling> dwelling_by_rules(const std::string& prompt,
                                                     const brief::DwellingKinds& dwellings,
                                                     const brief::RoomKinds& kinds) {
  auto said = brief::read_dwelling(prompt, dwellings, kinds, KindTable::built_in());
  if (said)
    for (auto& room : said->rooms) conclude(room.brief, kinds, KindTable::built_in());
  return said;
}

}  // namespace

Result<std::optional<DwellingPlan>> plan_dwelling(const PlanRequest& request, Designer& designer) {
  const std::optional<DwellingPlan> none;
  const auto& dwellings = brief::built_in_dwelling_kinds();
  if (!dwellings) return dwellings.error();
  const auto& kinds = brief::built_in_room_kinds();
  if (!kinds) return kinds.error();
  if (request.room || request.size) return none;
  const brief::SaidWish* read = brief::reading_of(request);
  const auto said = read ? read->dwelling : dwelling_by_rules(request.prompt, *dwellings, *kinds);
  if (!said) return none;

  const Random random = Random(request.seed).fork("dwelling");
  const auto laid = lay(*said, *dwellings, *kinds, random);
  auto rooms = make_rooms(laid, *kinds, random.fork("finish"));
  share_floors(rooms);
  plan::open_up(rooms, laid, *dwellings, *kinds, random.fork("openings"));
  if (auto status = check_dwelling(rooms); !status) return status.error();

  DwellingPlan plan;
  plan.prompt = request.prompt;
  plan.seed = request.seed;
  plan.notes = said->notes;
  if (laid.size() > said->rooms.size())
    plan.notes.push_back("a hallway was added, from which the rooms are entered");
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    PlanRequest own;
    const bool is_said = i < said->rooms.size();
    own.prompt = is_said ? request.prompt : "a " + rooms[i].type;
    own.seed = random.fork("plan of " + rooms[i].id).fork("seed").next();
    own.room = rooms[i];
    own.pictures = request.pictures;
    own.cancel = request.cancel;
    if (is_said)
      own.said = std::make_shared<brief::SaidWish>(
          brief::SaidWish{own.prompt, said->rooms[i].brief, {}, read && read->is_by_model});
    auto room = designer.plan(own);
    if (!room) return with_context(room.error(), "room \"" + rooms[i].id + "\"");
    plan.rooms.push_back(*std::move(room));
    name_requirements(plan.rooms.back());
  }
  number_through(plan);
  keep_ledger(*said, plan);
  return std::optional<DwellingPlan>(std::move(plan));
}

}  // namespace roomgen
