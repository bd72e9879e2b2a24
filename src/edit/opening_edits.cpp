#include <algorithm>

#include "draft_changes.h"
#include "generate/fit_openings.h"
#include "generate/window_cover.h"
#include "opening_places.h"
#include "operations.h"
#include "placing.h"
#include "plan/opening_plan.h"
#include "roomgen/base/text.h"
#include "walls.h"
#include "scene/dwelling.h"
#include "scene/opening_kind.h"

namespace roomgen {

namespace {

constexpr double before_window = 0.12;  // metres from a window that its curtains hang

// The room of an opening; in a dwelling its name may be "bedroom-0/window-0".
Result<const Room*> room_with(const Scene& scene, const std::string& opening, std::string& id) {
  const auto slash = opening.find('/');
  const std::string room_id = slash == std::string::npos ? "" : opening.substr(0, slash);
  id = slash == std::string::npos ? opening : opening.substr(slash + 1);
  std::vector<const Room*> rooms;
  std::vector<std::string> known;
  const auto look_at = [&](const Room& room) {
    if (!room_id.empty() && room.id != room_id) return;
    for (const auto& one : room.openings) known.push_back(room.id.empty() ? one.id : room.id + "/" + one.id);
    if (find_opening(room, id)) rooms.push_back(&room);
  };
  if (scene.rooms.empty()) look_at(scene.room);
  for (const auto& room : scene.rooms) look_at(room);
  if (rooms.size() == 1) return rooms.front();
  if (rooms.empty()) return cannot("there is no opening \"" + opening + "\": there are " + join(known, ", "));
  return Error{Error::Kind::not_understood,
               "several rooms have a \"" + id + "\"; say which: " + join(known, ", ")};
}

Opening opening_of(const OpeningKind& kind, const edit::Open& open, const Room& room, Random random) {
  brief::OpeningWish wish;
  wish.kind = kind.name;
  wish.type = kind.type;
  wish.width = open.width;
  wish.height = open.height;
  const auto& kinds = brief::built_in_room_kinds();
  const brief::RoomKind room_kind = kinds ? kinds->get(room.type) : brief::RoomKind();
  Opening opening = plan::wished_opening(wish, kind, room_kind, room.height, random).opening;
  if (open.sill) {
    opening.head += *open.sill - opening.sill;
    opening.sill = *open.sill;
  }
  return opening;
}

std::vector<Cluster> curtains_at(const Draft& draft, const Room& room, const Opening& opening) {
  std::vector<Cluster> curtains;
  const Segment line = segment(room, opening);
  for (const auto& object : draft.scene.objects)
    if (object.room == room.id && draft.shop.kinds().get(object.category).covers_window &&
        distance(line, object.position.head<2>()) < 0.5 * object.size.y() + before_window)
      curtains.push_back(Cluster{object, {}});
  return curtains;
}

Status hang_again(Draft& draft, const Room& room, const Opening& opening, const Object& curtain) {
  for (const auto& hung : hangings(curtain, draft.shop.kinds().get(curtain.category), room, opening))
    if (auto place = settled(draft, draft.shop.layout(draft.scene, room.id), Cluster{hung, {}})) {
      draft.put(*place);
      draft.repairs.push_back({curtain.id, curtain.position, place->root.position, 0.0});
      return {};
    }
  return cannot("there is no room for " + curtain.id + " there; remove it first");
}

// The mesh that the library has for it; else the room's own woodwork.
Status give_mesh(Draft& draft, const Room& room, Opening& opening) {
  const auto& kinds = OpeningKinds::built_in();
  if (!kinds) return kinds.error();
  Room alone = room;
  alone.openings = {opening};
  const auto used = fit_openings(alone, *kinds, draft.shop.library(), draft.random);
  if (!used) return used.error();
  opening = alone.openings.front();
  return {};
}

// In place of what was known by its name, or more.
Room with_opening(const Room& room, const Opening& opening) {
  Room changed = room;
  for (auto& one : changed.openings)
    if (one.id == opening.id) return one = opening, changed;
  changed.openings.push_back(opening);
  return changed;
}

// At the first of the places where the room takes it.
Status put_opening(Draft& draft, const Room& room, const std::vector<Opening>& places) {
  Status status = cannot("no wall has so much free length");
  for (const auto& place : places) {
    Draft trial = draft;
    Opening opening = place;
    if (auto given = give_mesh(trial, room, opening); !given) return given;
    status = change_room(trial, {with_opening(room, opening)});
    if (!status) continue;
    draft.take_over(std::move(trial));
    return {};
  }
  return status;
}

std::string words_for(const Opening& opening) {
  return opening.kind.empty() ? std::string(name(opening.type)) : opening.kind;
}

// So many of them is what is asked for from now on.
void wish_openings(Draft& draft, const std::string& room_id, const std::string& kind) {
  const Room& room = room_with_id(draft.scene, room_id);
  Requirement wish;
  wish.kind = Requirement::Kind::room;
  wish.source = Requirement::Source::edit;
  wish.attribute = "openings";
  wish.category = kind;
  wish.room = room_id;
  wish.amount = static_cast<double>(std::count_if(room.openings.begin(), room.openings.end(), [&](const Opening& one) {
    return words_for(one) == kind || name(one.type) == kind;
  }));
  wish.clause = std::to_string(static_cast<int>(wish.amount)) + " " + kind;
  draft.wishes.push_back(std::move(wish));
  draft.new_measures.insert("openings");
}

}  // namespace

Status carry_out(Draft& draft, const edit::Open& open) {
  const auto room_id = room_named(draft, open.room);
  if (!room_id) return room_id.error();
  const auto& kinds = OpeningKinds::built_in();
  if (!kinds) return kinds.error();
  const OpeningKind* kind = kinds->find(open.kind);
  if (!kind)
    return cannot("\"" + open.kind + "\" is no kind of door, window or passage that is known (docs/openings.md)");
  const Room room = room_with_id(draft.scene, *room_id);
  std::optional<std::size_t> wall;
  if (!open.wall.empty()) {
    const auto named = wall_named(room, open.wall);
    if (!named) return named.error();
    wall = *named;
  }
  Opening opening = opening_of(*kind, open, room, draft.random);
  opening.id = plan::free_opening_id(room, kind->type);
  if (std::max(opening.head, open.height.value_or(0.0)) > room.height)
    return cannot("it would be higher than the room");
  if (auto status = put_opening(draft, room, opening_places(draft.scene, room, opening, wall, open.at)); !status)
    return cannot("there is no place for a " + open.kind + ": " + status.error().message);
  wish_openings(draft, *room_id, std::string(name(kind->type)));
  return {};
}

Status carry_out(Draft& draft, const edit::Refit& refit) {
  std::string id;
  const auto found = room_with(draft.scene, refit.opening, id);
  if (!found) return found.error();
  const Room room = **found;
  Opening opening = *find_opening(room, id);
  if (!opening.leads_to.empty()) return cannot(id + " leads to " + opening.leads_to + ", whose wall it is in too");
  const auto curtains = curtains_at(draft, room, opening);
  const bool has_new_size = refit.width || refit.height || refit.sill;
  const double middle = 0.5 * (opening.from + opening.to), width = refit.width.value_or(opening.width());
  const double height = refit.height.value_or(opening.head - opening.sill);
  const auto wall = refit.wall.empty() ? Result<std::size_t>(opening.wall) : wall_named(room, refit.wall);
  if (!wall) return wall.error();
  opening.from = middle - 0.5 * width, opening.to = middle + 0.5 * width;
  opening.sill = refit.sill.value_or(opening.sill);
  opening.head = opening.sill + height;
  if (opening.head > room.height) return cannot(id + " would be higher than the room");
  if (has_new_size) opening.joinery = Joinery();
  const bool stays = refit.wall.empty() && !refit.at;
  for (const auto& curtain : curtains) draft.take_out(curtain.ids());
  auto places = opening_places(draft.scene, room, opening, *wall, stays ? std::optional(middle) : refit.at);
  if (auto status = put_opening(draft, room, places); !status)
    return cannot("there is no place for " + id + ": " + status.error().message);
  const Room& changed = room_with_id(draft.scene, room.id);
  for (const auto& curtain : curtains)
    if (auto status = hang_again(draft, changed, *find_opening(changed, id), curtain.root); !status) return status;
  return {};
}

// Nobody gets into a room without a door.
Status check_entrances(const Draft& draft, const Scene& before) {
  const auto closed = rooms_without_access(rooms_of(draft.scene)), were = rooms_without_access(rooms_of(before));
  for (const auto& room : closed)
    if (std::find(were.begin(), were.end(), room) == were.end())
      return cannot((room.empty() ? "the room" : room) +
                    " would have no way in any more; add another door first, or move this one to another wall");
  return {};
}

Status carry_out(Draft& draft, const edit::Close& close) {
  const Scene before = draft.scene;
  for (const auto& named : close.openings) {
    std::string id;
    const auto found = room_with(draft.scene, named, id);
    if (!found) return found.error();
    Room room = **found;
    const Opening opening = *find_opening(room, id);
    if (!opening.leads_to.empty())
      return cannot(id + " is the way to " + opening.leads_to + ", and ways between rooms stay as the dwelling was made");
    for (const auto& curtain : curtains_at(draft, room, opening)) {
      draft.take_out(curtain.ids());
      draft.named.insert(curtain.root.id);
      draft.new_categories.insert(curtain.root.category);
    }
    std::erase_if(room.openings, [&](const Opening& one) { return one.id == id; });
    for (auto& object : draft.scene.objects)
      if (object.room == room.id)
        std::erase_if(object.relations, [&](const Relation& one) { return one.target == id; });
    if (auto status = change_room(draft, {room}); !status) return status;
    wish_openings(draft, room.id, std::string(name(opening.type)));
  }
  return check_entrances(draft, before);
}

}  // namespace roomgen
