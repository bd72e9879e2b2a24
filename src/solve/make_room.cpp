#include <algorithm>
#include <set>
#include <string>

#include "arrange.h"
#include "improve.h"

namespace roomgen {

namespace {

constexpr int tries = 4;
constexpr std::size_t most_things = 24;  ///< on one support; the search is not for more

// What must hold of those that move.
enum class Keep { everything, wishes, support };

PlacementTask relaxed(PlacementTask task, Keep keep) {
  auto& relations = task.object.relations;
  if (keep == Keep::wishes)
    relations.resize(std::min(relations.size(), static_cast<std::size_t>(task.wishes)));
  if (keep == Keep::support)
    std::erase_if(relations, [](const Relation& one) { return one.kind != RelationKind::on; });
  return task;
}

// What stands on the support, on that again, and so on, as far as it can move.
std::vector<PlacementTask> things_on(const Layout& layout, const std::string& support,
                                     const std::vector<PlacementTask>& tasks, bool words_stay) {
  std::vector<PlacementTask> found;
  std::set<std::string> carriers = {support};
  for (const auto& task : tasks) {
    const Object* placed = layout.find(task.object.id);
    if (!placed || placed->locked || !carriers.count(placed->on)) continue;
    if (words_stay && task.binding) continue;
    carriers.insert(placed->id);
    found.push_back(task);
  }
  return found;
}

bool arrange_anew(Layout& layout, const std::vector<PlacementTask>& tasks, Keep keep,
                  const CancelToken& cancel, Random& random) {
  std::vector<PlacementTask> wanted;
  for (const auto& task : tasks) wanted.push_back(relaxed(task, keep));
  std::vector<const PlacementTask*> members;
  for (const auto& task : wanted) members.push_back(&task);
  ArrangeOptions options;
  options.tries = tries;
  options.cancel = cancel;
  return arrange(layout, members, options, random);
}

// What was arranged under relaxed constraints keeps its own.
void restore_relations(Layout& layout, const std::vector<PlacementTask>& tasks) {
  for (const auto& task : tasks) {
    Object object = *layout.find(task.object.id);
    layout.remove(object.id);
    object.relations = task.object.relations;
    layout.add(std::move(object));
  }
}

bool make_room_among(Layout& layout, const PlacementTask& newcomer,
                     std::vector<PlacementTask> moving, const CancelToken& cancel,
                     Random& random) {
  if (moving.empty() || moving.size() >= most_things) return false;
  std::vector<Object> before;
  for (const auto& task : moving) before.push_back(*layout.find(task.object.id));
  for (const auto& object : before) layout.remove(object.id);
  moving.push_back(newcomer);
  for (const Keep keep : {Keep::everything, Keep::wishes, Keep::support})
    if (arrange_anew(layout, moving, keep, cancel, random)) {
      restore_relations(layout, moving);
      return true;
    }
  for (auto& object : before) layout.add(std::move(object));
  return false;
}

}  // namespace

bool make_room(Layout& layout, const PlacementTask& newcomer,
               const std::vector<PlacementTask>& tasks, const CancelToken& cancel,
               Random& random) {
  if (newcomer.object.on.empty()) return false;
  auto all = things_on(layout, newcomer.object.on, tasks, false);
  auto movable = things_on(layout, newcomer.object.on, tasks, true);
  if (movable.size() < all.size() &&
      make_room_among(layout, newcomer, std::move(movable), cancel, random))
    return true;
  return make_room_among(layout, newcomer, std::move(all), cancel, random);
}

}  // namespace roomgen
