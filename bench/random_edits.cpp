#include "random_edits.h"

#include <algorithm>
#include <vector>

namespace roomgen::bench {

namespace {

struct Usual {
  const char* category;
  Mount mount;
};
constexpr Usual newcomers[] = {
    {"armchair", Mount::floor},   {"floor lamp", Mount::floor}, {"plant", Mount::floor},    {"stool", Mount::floor},
    {"side table", Mount::floor}, {"bookshelf", Mount::floor},  {"cabinet", Mount::floor},  {"bench", Mount::floor},
    {"ottoman", Mount::floor},    {"dresser", Mount::floor},    {"chair", Mount::floor},    {"desk", Mount::floor},
    {"sofa", Mount::floor},       {"basket", Mount::floor},     {"vase", Mount::surface},   {"book", Mount::surface},
    {"mug", Mount::surface},      {"table lamp", Mount::surface}, {"picture", Mount::wall}, {"wall clock", Mount::wall}};
constexpr const char* words_of_carriers[] = {"table", "desk", "cabinet", "shelf", "dresser", "nightstand", "sideboard", "counter"};
// What people say most comes most often.
constexpr RelationKind places[] = {RelationKind::next_to,  RelationKind::next_to,     RelationKind::near,
                                   RelationKind::left_of,  RelationKind::right_of,    RelationKind::in_front_of,
                                   RelationKind::behind,   RelationKind::far};
constexpr double furthest_put = 0.5;  // metres from where it stands

bool may_carry(const Object& object) {
  return object.mount != Mount::wall && object.mount != Mount::ceiling &&
         std::any_of(std::begin(words_of_carriers), std::end(words_of_carriers),
                     [&](const char* word) { return object.category.find(word) != std::string::npos; });
}

template <typename Which>
const Object* one_that(const Scene& scene, Random& random, Which which) {
  std::vector<const Object*> found;
  for (const auto& object : scene.objects)
    if (which(object)) found.push_back(&object);
  return found.empty() ? nullptr : random.pick(found);
}

bool stands(const Object& object) { return object.mount == Mount::floor && !object.traits.flat; }

std::vector<Relation> place_on_floor(const Scene& scene, const std::string& own, Random& random) {
  const Object* target = one_that(scene, random, [&](const Object& one) { return stands(one) && one.id != own; });
  const int what = random.integer(0, 9);
  if (what <= 1 || !target) return {{RelationKind::edge, ""}};
  if (what == 2) return {{RelationKind::corner, ""}};
  if (what == 3 && !scene.room.openings.empty()) return {{RelationKind::near, random.pick(scene.room.openings).id}};
  return {{places[random.integer(0, static_cast<int>(std::size(places)) - 1)], target->id}};
}

std::vector<Relation> place_on_top(const Scene& scene, Random& random) {
  const Object* carrier = one_that(scene, random, may_carry);
  return carrier ? std::vector<Relation>{{RelationKind::on, carrier->id}} : std::vector<Relation>{};
}

edit::Operation insertion(const Scene& scene, Random& random) {
  const Usual& usual = newcomers[random.integer(0, static_cast<int>(std::size(newcomers)) - 1)];
  edit::Add add{usual.category, ""};
  if (random.chance(0.25)) return add;
  if (usual.mount == Mount::surface) add.relations = place_on_top(scene, random);
  else if (usual.mount == Mount::floor) add.relations = place_on_floor(scene, "", random);
  else if (const Object* below = one_that(scene, random, stands)) add.relations = {{RelationKind::above, below->id}};
  return add;
}

edit::Operation move_to_relation(const Scene& scene, Random& random) {
  const Object& one = *one_that(scene, random, [](const Object& object) {
    return stands(object) || object.mount == Mount::surface;
  });
  return edit::Move{one.id, stands(one) ? place_on_floor(scene, one.id, random) : place_on_top(scene, random)};
}

edit::Operation move_to_place(const Scene& scene, Random& random) {
  const Object& one = *one_that(scene, random, stands);
  Vec2 by = Vec2::Zero();
  for (int axis = 0; axis < 2; ++axis) by[axis] = random.uniform(-furthest_put, furthest_put);
  if (random.chance(0.5)) by[random.integer(0, 1)] = 0.0;
  if (random.chance(0.5)) return edit::Shift{one.id, {by.x(), by.y(), 0.0}};
  edit::Put put{one.id, Vec2(one.position.head<2>()) + by};
  if (random.chance(0.5)) put.yaw = wrap_angle(one.yaw + 0.5 * pi * random.integer(1, 3));
  return put;
}

edit::Operation turn(const Scene& scene, Random& random) {
  const Object& one = *one_that(scene, random, stands);
  const Object* target = one_that(scene, random, [&](const Object& other) { return stands(other) && other.id != one.id; });
  if (one.traits.front && target && random.chance(0.5)) return edit::Face{one.id, target->id};
  return edit::Turn{one.id, 0.25 * pi * random.integer(1, 7)};
}

edit::Operation resize(const Scene& scene, Random& random) {
  const Object& one = random.pick(scene.objects);
  Vec3 size = one.size;
  if (random.chance(0.5)) size *= random.uniform(0.7, 1.4);
  else size[random.integer(0, 2)] *= random.uniform(0.6, 1.6);
  return edit::Resize{one.id, size};
}

}  // namespace

edit::Operation random_edit(const Scene& scene, Random& random) {
  if (!one_that(scene, random, stands)) return insertion(scene, random);
  const int what = random.integer(0, 19);
  if (what <= 5) return insertion(scene, random);
  if (what <= 7) return edit::Remove{{random.pick(scene.objects).id}};
  if (what <= 11) return move_to_relation(scene, random);
  if (what <= 13) return move_to_place(scene, random);
  if (what <= 15) return edit::Replace{random.pick(scene.objects).id};
  if (what <= 17) return turn(scene, random);
  return resize(scene, random);
}

const char* sort_of(const edit::Operation& operation) {
  if (std::holds_alternative<edit::Add>(operation)) return "insertion";
  if (std::holds_alternative<edit::Remove>(operation)) return "removal";
  if (std::holds_alternative<edit::Move>(operation)) return "move to a relation";
  if (std::holds_alternative<edit::Put>(operation) || std::holds_alternative<edit::Shift>(operation))
    return "move to a place";
  if (std::holds_alternative<edit::Replace>(operation)) return "replacement";
  if (std::holds_alternative<edit::Resize>(operation)) return "resize";
  return "turn";
}

}  // namespace roomgen::bench
