#include "words.h"

#include <algorithm>
#include <cmath>

#include "scene/judgement.h"

namespace roomgen {

namespace {

// Of the way back, the shares at which a thing that cannot go all of it may stay.
constexpr double stays[] = {0.0, 0.15, 0.3, 0.45, 0.6, 0.8};

// A thing and all that stands on it.
std::vector<Object> with_load(const Layout& layout, const Object& leader) {
  std::vector<Object> group = {leader};
  for (std::size_t i = 0; i < group.size(); ++i)
    for (const auto& other : layout.objects())
      if (other.on == group[i].id) group.push_back(other);
  return group;
}

// The group as it goes with its first member to a pose.
std::vector<Object> moved_to(std::vector<Object> group, const Vec3& position, double yaw) {
  const Vec3 from = group.front().position;
  const double turn = wrap_angle(yaw - group.front().yaw);
  for (auto& object : group) {
    const Vec2 aside = rotated(Vec2((object.position - from).head<2>()), turn);
    object.position = position + Vec3(aside.x(), aside.y(), object.position.z() - from.z());
    object.yaw = wrap_angle(object.yaw + turn);
    object = with_rounded_pose(std::move(object));
  }
  return group;
}

bool may_stand(Layout& layout, const Object& object) {
  const auto candidate = layout.candidate(object);
  return layout.fits(candidate, footprint(object), bottom(object)) &&
         layout.fits_exactly(candidate);
}

void put(Layout& layout, const std::vector<Object>& group) {
  for (const auto& object : group) layout.remove(object.id);
  for (const auto& object : group) layout.add(object);
}

// Whether the group found room there; if not, it is not in the layout.
bool put_if_free(Layout& layout, const std::vector<Object>& group) {
  for (const auto& object : group) layout.remove(object.id);
  for (const auto& object : group) {
    if (!may_stand(layout, object)) return false;
    layout.add(object);
  }
  return true;
}

}  // namespace

Words::Words(const Layout& layout, const std::vector<PlacementTask>& tasks) {
  const auto count = static_cast<double>(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const Object* placed = tasks[i].binding ? layout.find(tasks[i].object.id) : nullptr;
    if (!placed) continue;
    stood_.push_back({*placed, 2.0 - static_cast<double>(i) / count});
    for (const Object* one = placed; one; one = layout.find(one->on))
      if (!held_.insert(one->id).second) break;
  }
}

double Words::displaced(const Layout& layout) const {
  double sum = 0.0;
  for (const auto& [stood, weight] : stood_) {
    const Object* now = layout.find(stood.id);
    if (!now) continue;
    sum += weight * ((now->position - stood.position).norm() +
                     layout.weights().metres_a_radian * std::abs(wrap_angle(now->yaw - stood.yaw)));
  }
  return sum;
}

void Words::bring_back(Layout& layout, const std::function<bool()>& is_no_worse) const {
  for (const auto& [stood, weight] : stood_) {
    const Object* found = layout.find(stood.id);
    if (!found || found->mount == Mount::surface) continue;
    if (found->position == stood.position && found->yaw == stood.yaw) continue;
    const auto group = with_load(layout, *found);
    const Object now = group.front();
    for (const double share : stays) {
      const Vec3 position = stood.position + share * (now.position - stood.position);
      const double yaw = wrap_angle(stood.yaw + share * wrap_angle(now.yaw - stood.yaw));
      if (put_if_free(layout, moved_to(group, position, yaw)) && is_no_worse()) break;
      put(layout, group);
    }
  }
}

bool requirements_hold(const Layout& layout, const std::vector<PlacementTask>& tasks) {
  return std::all_of(tasks.begin(), tasks.end(), [&](const PlacementTask& task) {
    const Object* placed = layout.find(task.object.id);
    if (!placed) return !task.asked;
    const auto relations = resolve(*placed, layout.room(), layout.objects(), layout.categories());
    const Subject subject{footprint(*placed), bottom(*placed), top(*placed)};
    const auto wishes = std::min(static_cast<std::size_t>(task.wishes), relations.size());
    return std::all_of(relations.begin(), relations.begin() + static_cast<std::ptrdiff_t>(wishes),
                       [&](const ResolvedRelation& relation) {
                         return judge(relation, subject, layout.room()).held;
                       });
  });
}

}  // namespace roomgen
