#include <algorithm>

#include "base/random.h"
#include "brief/room_kinds.h"
#include "plan/floor_plan.h"
#include "plan/looks.h"
#include "plan/opening_plan.h"
#include "roomgen/base/text.h"
#include "roomgen/design/designer.h"
#include "scene/dwelling.h"
#include "scene/opening_kind.h"
#include "scene/wall_sides.h"

namespace roomgen {

namespace {

using Shared = std::vector<SharedStretch>;

/// Gives the openings that a plan wants their places: those told first, then the others around
/// them.
class WantedOpenings {
 public:
  WantedOpenings(Plan& plan, const brief::RoomKinds& kinds, const Shared& shared)
      : plan_(plan),
        room_kind_(kinds.get(plan.room.type)),
        shared_(shared),
        random_(Random(plan.seed).fork("wanted openings")) {}

  void run() {
    std::vector<plan::OpeningNeed> without_place;
    for (std::size_t i = 0; i < plan_.openings.size(); ++i) {
      const WantedOpening& wanted = plan_.openings[i];
      auto need = need_of(wanted);
      if (!need) continue;
      need->opening.id = pointer(i);
      need->walls = walls_named(plan_.room, wanted.wall);
      if (wanted.at || wanted.offset)
        put(*need, wanted);
      else
        without_place.push_back(*std::move(need));
    }
    place(std::move(without_place));
    for (auto& opening : plan_.room.openings)
      if (opening.id.starts_with("/openings/")) opening.id.clear();
    plan::name_openings(plan_.room);
    plan_.openings.clear();
  }

 private:
  static std::string pointer(std::size_t i) { return "/openings/" + std::to_string(i); }

  std::optional<plan::OpeningNeed> need_of(const WantedOpening& wanted) {
    const auto& kinds = OpeningKinds::built_in();
    const OpeningKind* kind = kinds ? kinds->find(wanted.kind) : nullptr;
    if (!kind) return std::nullopt;
    brief::OpeningWish wish;
    wish.kind = kind->name;
    wish.type = kind->type;
    wish.width = wanted.width;
    auto need = plan::wished_opening(wish, *kind, room_kind_, plan_.room.height, random_);
    if (wanted.head) need.opening.head = *wanted.head;
    if (wanted.sill) need.opening.sill = *wanted.sill;
    need.opening.purpose = wanted.purpose;
    return need;
  }

  void put(const plan::OpeningNeed& need, const WantedOpening& wanted) {
    Opening opening = need.opening;
    opening.wall = need.walls.front();
    const double length = plan_.room.polygon.edge(opening.wall).length();
    const double middle = wanted.at ? *wanted.at * length : 0.5 * length + *wanted.offset;
    opening.from = middle - 0.5 * need.opening.width();
    opening.to = middle + 0.5 * need.opening.width();
    add(opening);
  }

  void place(std::vector<plan::OpeningNeed> needs) {
    plan::OpeningPlaces places{plan::bare_walls(plan_.room), nullptr};
    for (const auto& stretch : shared_)
      plan::cut(places.stretches, stretch.wall, stretch.from, stretch.to);
    std::vector<std::string> left;
    for (const auto& need : needs) left.push_back(need.opening.id);
    std::vector<std::string> notes;
    const Room bare = plan_.room;
    for (auto& opening : plan::place_openings(bare, places, std::move(needs), random_, notes)) {
      std::erase(left, opening.id);
      add(opening);
    }
    for (const auto& note : notes) plan_.notes.push_back("/openings: " + note);
    for (const auto& id : left) plan_.notes.push_back(id + ": there is no place for it");
  }

  // Unless the room would be unsound.
  void add(const Opening& opening) {
    Room with = plan_.room;
    with.openings.push_back(opening);
    const bool is_between =
        std::any_of(shared_.begin(), shared_.end(), [&](const SharedStretch& stretch) {
          return stretch.wall == opening.wall && opening.from < stretch.to &&
                 stretch.from < opening.to;
        });
    const auto status = check(with);
    if (status && !is_between)
      plan_.room = std::move(with);
    else
      plan_.notes.push_back((is_between ? opening.id + ": another room is behind that wall"
                                        : status.error().message) +
                            "; left out");
  }

  Plan& plan_;
  const brief::RoomKind& room_kind_;
  const Shared& shared_;
  Random random_;
};

// Colours that a description can be searched with.
std::vector<std::string> words_of(const Room& room) {
  std::vector<std::string> said;
  for (const auto& role : palette_roles)
    if (const auto found = room.palette.find(role);
        found != room.palette.end() && !found->second.starts_with('#'))
      said.push_back(found->second);
  return said;
}

// What nobody said of floor, walls and things, from the style and the palette that somebody did
// say.
void dress(Plan& plan, const brief::RoomKinds& kinds) {
  Room& room = plan.room;
  if (room.style.empty() && room.palette.empty()) return;
  const Random random = Random(plan.seed).fork("style");
  const RoomMaterials said = room.materials;
  if (const StyleMeaning* style = plan::style_named(kinds, room.style))
    plan::put_on(room, *style, random);
  const auto wear = [&](std::string_view role, std::string& part, const char* noun) {
    if (const auto found = room.palette.find(role); found != room.palette.end())
      part = found->second + noun;
  };
  wear("main", room.materials.walls, " walls");
  wear("wood", room.materials.floor, " floor");
  plan::put_on(room, said);
  const plan::Looks looks(kinds, KindTable::built_in(), room.style,
                          plan::style_of_palette(words_of(room)), {}, random);
  for (auto& item : plan.items) item.description = looks.in_style(item.category, item.description);
}

void settle(Plan& plan, const Shared& shared) {
  const auto& kinds = brief::built_in_room_kinds();
  if (!kinds) return;
  if (!plan.openings.empty()) WantedOpenings(plan, *kinds, shared).run();
  dress(plan, *kinds);
}

}  // namespace

void settle(Plan& plan) {
  settle(plan, {});
}

void settle(DwellingPlan& plan) {
  std::vector<Room> rooms;
  for (const auto& room : plan.rooms) rooms.push_back(room.room);
  for (std::size_t i = 0; i < plan.rooms.size(); ++i)
    settle(plan.rooms[i], shared_stretches(rooms, i));
}

}  // namespace roomgen
