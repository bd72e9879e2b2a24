#include "movable.h"

#include <algorithm>

#include "compatible.h"
#include "scene/relation_table.h"

namespace roomgen {

namespace {

// Places of an anchor about which poses are looked for, besides those of the examples.
constexpr std::size_t most_stands = 16;

std::optional<std::size_t> index_of(std::span<const PlacementTask> tasks, const std::string& id) {
  for (std::size_t i = 0; i < tasks.size(); ++i)
    if (tasks[i].object.id == id) return i;
  return std::nullopt;
}

// Who stands between two things goes along with neither.
bool ties(const Relation& relation) {
  return places(relation) && relation.kind != RelationKind::between;
}

// What carries it; else, of the things that its constraints place it by, the one most of them name.
std::optional<std::size_t> anchor_of(std::span<const PlacementTask> tasks, const Object& object) {
  if (const auto support = index_of(tasks, object.on)) return support;
  std::optional<std::size_t> best;
  std::ptrdiff_t most = 0;
  for (const auto& relation : object.relations) {
    const auto target = index_of(tasks, relation.target);
    if (!target || !ties(relation)) continue;
    const auto named = std::count_if(object.relations.begin(), object.relations.end(), [&](const Relation& other) {
      return other.target == relation.target;
    });
    if (named > most) best = target, most = named;
  }
  return best;
}

std::vector<BoundRelation> bound_relations(const Layout& layout, std::span<const PlacementTask> tasks,
                                           const Object& object) {
  std::vector<BoundRelation> bound;
  auto resolved = resolve(object, layout.room(), layout.objects(), layout.categories());
  for (std::size_t i = 0; i < resolved.size(); ++i) {
    BoundRelation one{std::move(resolved[i])};
    one.target = index_of(tasks, object.relations[i].target);
    if (one.relation.kind == RelationKind::between)
      for (const auto& relation : object.relations)
        if (relation.kind == RelationKind::between && relation.target != object.relations[i].target)
          one.other = index_of(tasks, relation.target);
    bound.push_back(std::move(one));
  }
  // What hangs on a wall goes from wall to wall.
  if (object.mount == Mount::wall) {
    ResolvedRelation at_wall;
    at_wall.targets = {Footprint()};
    bound.push_back({std::move(at_wall)});
  }
  return bound;
}

// In placement order, one pass reaches all.
std::vector<std::size_t> dependants_of(std::span<const PlacementTask> tasks, std::size_t first) {
  std::vector<std::size_t> family = {first};
  for (std::size_t i = first + 1; i < tasks.size(); ++i)
    if (std::any_of(family.begin(), family.end(),
                    [&](std::size_t j) { return depends_on(tasks[i].object, tasks[j].object.id); }))
      family.push_back(i);
  family.erase(family.begin());
  return family;
}

// Evenly chosen, after those of the examples.
Poses typical(const Poses& all, std::size_t thing, std::span<const Poses> examples) {
  Poses chosen;
  for (const auto& example : examples) chosen.push_back(example[thing]);
  const std::size_t count = std::min(most_stands, all.size());
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(all[i * all.size() / count]);
  return chosen;
}

void stand_as(Layout& layout, std::span<const PlacementTask> tasks, const Poses& poses) {
  for (std::size_t i = 0; i < tasks.size(); ++i) layout.add(at_pose(tasks[i].object, poses[i]));
}

}  // namespace

std::vector<bool> immovable(std::span<const PlacementTask> tasks, const KindTable& kinds) {
  std::vector<bool> stays(tasks.size(), false);
  // What carries a thing comes before it.
  for (std::size_t i = tasks.size(); i-- > 0;) {
    const Object& object = tasks[i].object;
    stays[i] = stays[i] || object.locked || kinds.get(object.category).covers_window;
    if (const auto support = index_of(tasks, object.on); support && stays[i]) stays[*support] = true;
  }
  return stays;
}

std::vector<Movable> make_movables(Layout& layout, std::span<const PlacementTask> tasks,
                                   std::span<const Poses> examples) {
  std::vector<Movable> movables;
  const auto stays = immovable(tasks, layout.categories());
  stand_as(layout, tasks, examples.front());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const Object& object = tasks[i].object;
    movables.push_back({tasks[i], stays[i], bound_relations(layout, tasks, object),
                        stays[i] ? std::nullopt : anchor_of(tasks, object), dependants_of(tasks, i), {}});
  }
  layout.clear();

  std::vector<Poses> stands;
  for (std::size_t i = 0; i < movables.size(); ++i) {
    Movable& movable = movables[i];
    DomainSearch search(layout, movable.task);
    if (movable.fixed) {
      // It has one place.
    } else if (movable.anchor) {
      for (const auto& stand : stands[*movable.anchor]) {
        const Object anchor = at_pose(tasks[*movable.anchor].object, stand);
        search.look(&anchor);
      }
    } else {
      search.look(nullptr);
    }
    stands.push_back(typical(search.stands(), i, examples));
    movable.domain = search.take_domain();
  }
  return movables;
}

}  // namespace roomgen
