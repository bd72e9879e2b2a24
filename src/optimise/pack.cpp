#include "pack.h"

#include <algorithm>
#include <map>

#include "anneal.h"
#include "evaluator.h"
#include "moves.h"
#include "solve/layout.h"

namespace roomgen {

namespace {

using namespace annealing;

// What counts how much, in violations. A thing that is left out counts with what it covers: a bedroom does without a
// shelf rather than without its bed.
constexpr double asked_missing = 1.0, added_missing = 0.3, wish_lost = 0.05, relation_lost = 0.005;
constexpr double bare = 0.5;  // m2 added to each footprint
// A search that starts with a room need not begin hot.
constexpr double warm = 1.5, near_by = 0.8;

constexpr int on_floor = 0, hanging = 1, at_wall = 2, on_thing = 3, first_flush = 4;

/// A packing as a program: each thing is the only one of its kind number, with a set and a bound of its own.
struct PackProgram {
  Compiled compiled;
  std::vector<Article> articles;
  std::vector<std::vector<int>> articles_of_kind;
  std::vector<Bound> bounds;
  std::vector<PutUp> relations;
};

bool wants_wall(const Object& object) {
  return object.mount == Mount::floor && std::ranges::any_of(object.relations, [](const Relation& relation) {
           return relation.kind == RelationKind::edge || relation.kind == RelationKind::corner;
         });
}

void name_relations(PackProgram& program, std::size_t things) {
  program.relations = {{PutUp::Type::stable_against, {Face::bottom}, {Face::floor}, 0.0, true},
                       {PutUp::Type::stable_against, {Face::top}, {Face::ceiling}, 0.0, true},
                       {PutUp::Type::stable_against, {Face::back}, {Face::wall}, 0.0, true},
                       {PutUp::Type::stable_against, {Face::bottom}, {Face::support}, 0.0, true}};
  program.compiled.language.names = {"on_floor", "hanging", "flush_wall", "on"};
  // Against a wall, as far from it as the thing stood.
  for (std::size_t i = 0; i < things; ++i) {
    program.relations.push_back({PutUp::Type::stable_against, {Face::back}, {Face::wall}, 0.0, true});
    program.compiled.language.names.push_back("flush " + std::to_string(i));
  }
  program.compiled.language.relations = program.relations;
}

int room_set(PackProgram& program) {
  SetNode room;
  room.source = ProgramSet::Source::room;
  program.compiled.sets.push_back(room);
  return static_cast<int>(program.compiled.sets.size()) - 1;
}

// The set of the things of these numbers.
int set_of(PackProgram& program, const std::vector<std::size_t>& numbers, std::size_t things) {
  KindFilter filter;
  filter.passes.assign(things, 0);
  for (const std::size_t number : numbers) filter.passes[number] = 1;
  program.compiled.filters.push_back(filter);
  SetNode node;
  node.source = ProgramSet::Source::described;
  node.filter = static_cast<int>(program.compiled.filters.size()) - 1;
  program.compiled.sets.push_back(node);
  return static_cast<int>(program.compiled.sets.size()) - 1;
}

std::optional<std::size_t> number_of(const std::vector<PackThing>& things, const std::string& id) {
  const auto found = std::ranges::find_if(things, [&](const PackThing& thing) { return thing.object.id == id; });
  return found == things.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - things.begin()));
}

// What may carry a thing: what its relations or its place name, else whatever carries things.
std::vector<std::size_t> carriers_of(const std::vector<PackThing>& things, std::size_t i, const KindTable& kinds) {
  const Object& object = things[i].object;
  for (const auto& relation : object.relations)
    if (relation.kind == RelationKind::on || relation.kind == RelationKind::inside)
      if (const auto target = number_of(things, relation.target)) return {*target};
  if (const auto target = number_of(things, object.on)) return {*target};
  std::vector<std::size_t> all;
  for (std::size_t k = 0; k < things.size(); ++k)
    if (k != i && kinds.get(things[k].object.category).supports) all.push_back(k);
  return all;
}

Recipe recipe_of(PackProgram& program, const std::vector<PackThing>& things, std::size_t i, int room,
                 const KindTable& kinds) {
  Recipe recipe;
  recipe.kinds = {static_cast<int>(i)};
  const Object& object = things[i].object;
  switch (object.mount) {
    case Mount::ceiling: recipe.relations = {{hanging, room}}; break;
    case Mount::wall: recipe.relations = {{at_wall, room}}; break;
    case Mount::surface:
      recipe.relations = {{on_thing, set_of(program, carriers_of(things, i, kinds), things.size())}};
      break;
    default: recipe.relations = {{on_floor, room}}; break;
  }
  if (wants_wall(object)) recipe.relations.push_back({first_flush + static_cast<int>(i), room});
  return recipe;
}

Tie tie_of(const std::vector<PackThing>& things, std::size_t i) {
  const PackThing& thing = things[i];
  Tie tie;
  tie.kind_number = static_cast<int>(i);
  tie.missing = (thing.asked ? asked_missing : added_missing) * (bare + thing.object.size.head<2>().prod());
  tie.relations = thing.object.relations;
  for (std::size_t r = 0; r < tie.relations.size(); ++r) {
    const auto target = number_of(things, tie.relations[r].target);
    tie.targets.push_back(target ? static_cast<int>(*target) : -1);
    tie.lost.push_back(static_cast<int>(r) < thing.wishes ? wish_lost : relation_lost);
  }
  return tie;
}

PackProgram program_of(const std::vector<PackThing>& things, const KindTable& kinds) {
  PackProgram program;
  name_relations(program, things.size());
  const int room = room_set(program);
  for (std::size_t i = 0; i < things.size(); ++i) {
    const int number = static_cast<int>(i);
    program.articles.push_back({things[i].object, &kinds.get(things[i].object.category), number});
    program.articles_of_kind.push_back({number});
    program.compiled.ties.push_back(tie_of(things, i));
    Bound bound;
    bound.set = set_of(program, {i}, things.size());
    bound.low = bound.high = 1.0;
    bound.recipes = {recipe_of(program, things, i, room, kinds)};
    program.bounds.push_back(std::move(bound));
  }
  return program;
}

Attachment to_room(int relation, Face child, Face parent) {
  Attachment attachment;
  attachment.relation = relation, attachment.child = child, attachment.parent = parent;
  return attachment;
}

// The wall at the back of a thing, and how far off it is; nothing if none is near.
std::optional<std::pair<int, double>> wall_behind(const Object& object, const Room& room) {
  constexpr double near = 0.3, parallel = 1e-3;
  const Footprint own = footprint(object);
  for (std::size_t k = 0; k < room.polygon.size(); ++k) {
    const Vec2 in = room.polygon.inward(k);
    if (own.front().dot(in) < 1.0 - parallel) continue;
    const double off = in.dot(own.center() - room.polygon.points[k]) - own.half().y();
    const Segment wall = room.polygon.edge(k);
    const double along = wall.direction().dot(own.center() - wall.a);
    if (off < near && off > -0.01 && along > 0.0 && along < wall.length())
      return std::pair(static_cast<int>(k), std::max(0.0, off));
  }
  return std::nullopt;
}

// How a thing that stands is put up.
Stance stance_of(const Object& object, std::size_t number, const std::map<std::string, Slot>& slots, const World& world,
                 PackProgram& program) {
  Stance stance;
  stance.position = object.position.head<2>();
  stance.bottom = object.position.z();
  stance.yaw = object.yaw;
  const auto hold = [&](const Attachment& attachment) { stance.attachments[stance.count++] = attachment; };
  if (object.mount == Mount::floor) hold(to_room(on_floor, Face::bottom, Face::floor));
  if (object.mount == Mount::ceiling) hold(to_room(hanging, Face::top, Face::ceiling));
  if (object.mount == Mount::wall || wants_wall(object))
    if (const auto wall = wall_behind(object, world.room())) {
      const int relation = first_flush + static_cast<int>(number);
      program.relations[static_cast<std::size_t>(relation)].margin = wall->second;
      Attachment attachment = to_room(relation, Face::back, Face::wall);
      attachment.wall = wall->first;
      hold(attachment);
    }
  if (const auto carrier = slots.find(object.on); object.mount == Mount::surface && carrier != slots.end()) {
    Attachment attachment = to_room(on_thing, Face::bottom, Face::support);
    attachment.target = carrier->second;
    hold(attachment);
    const Object& below = world.item(carrier->second).object;
    stance.rest = SupportPose{footprint(below).to_local(stance.position), stance.bottom - bottom(below),
                              wrap_angle(stance.yaw - below.yaw), 0};
  }
  return stance;
}

// What stands, carriers first.
void furnish(World& world, const std::vector<PackThing>& things, PackProgram& program) {
  std::map<std::string, Slot> slots;
  std::vector<char> done(things.size(), 0);
  for (bool grown = true; grown;) {
    grown = false;
    for (std::size_t i = 0; i < things.size(); ++i) {
      const PackThing& thing = things[i];
      const bool waits = thing.object.mount == Mount::surface && !slots.contains(thing.object.on);
      if (done[i] || !thing.stands || waits) continue;
      const Slot slot = static_cast<Slot>(slots.size());
      world.add_at(slot, static_cast<int>(i), stance_of(thing.object, i, slots, world, program), static_cast<int>(i));
      if (!thing.movable) world.fix(slot);
      slots[thing.object.id] = slot;
      done[i] = 1, grown = true;
    }
  }
}

std::vector<Object> objects_of(const std::vector<Placed>& placed, const std::vector<PackThing>& things) {
  std::map<Slot, std::string> ids;
  for (const auto& each : placed) ids[each.slot] = things[static_cast<std::size_t>(each.article)].object.id;
  std::vector<Object> objects(things.size());
  std::vector<char> stands(things.size(), 0);
  for (const auto& each : placed) {
    const auto i = static_cast<std::size_t>(each.article);
    Object object = things[i].object;
    object.position << each.stance.position, each.stance.bottom;
    object.yaw = each.stance.yaw;
    for (const auto& attachment : each.stance.held())
      if (attachment.parent == Face::support) object.on = ids.at(attachment.target);
    objects[i] = with_rounded_pose(std::move(object));
    stands[i] = 1;
  }
  std::vector<Object> result;
  for (std::size_t i = 0; i < things.size(); ++i)
    if (stands[i]) result.push_back(std::move(objects[i]));
  return result;
}

}  // namespace

Packing pack(const Room& room, const std::vector<PackThing>& things, const ModelTable& models, const KindTable& kinds,
             const PackOptions& options) {
  PackProgram program = program_of(things, kinds);
  World world(room, kinds, program.articles, models, program.relations);
  Evaluator evaluator(program.compiled, world);
  furnish(world, things, program);
  const double before = evaluator.worth().violation;
  Random random = Random(options.seed).fork("pack");
  Moves moves(world, evaluator, program.bounds, program.articles_of_kind, program.compiled.language, random);
  AnnealOptions how;
  how.steps = options.steps;
  how.cancel = options.cancel;
  how.always_usable = true;
  if (std::ranges::any_of(things, &PackThing::stands)) how.hottest = warm, how.widest = near_by;
  const AnnealResult found = anneal(world, evaluator, moves, random, how);
  Packing packing;
  packing.is_better = !found.curve.empty() && found.worth.violation < before - 1e-6;
  packing.objects = objects_of(found.best, things);
  return packing;
}

}  // namespace roomgen
