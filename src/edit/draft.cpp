#include "draft.h"

#include <algorithm>

#include "roomgen/base/text.h"
#include "scene/dwelling.h"

namespace roomgen {

std::set<std::string> Cluster::ids() const {
  std::set<std::string> all = {root.id};
  for (const auto& object : carried) all.insert(object.id);
  return all;
}

namespace {

// What stands on one of these comes along, and on what does.
Cluster with_carried(const Scene& scene, Cluster cluster) {
  std::set<std::string> carriers = cluster.ids();
  for (bool grew = true; grew;) {
    grew = false;
    for (const auto& object : scene.objects)
      if (!object.on.empty() && carriers.count(object.on) && !carriers.count(object.id)) {
        cluster.carried.push_back(object);
        carriers.insert(object.id);
        grew = true;
      }
  }
  return cluster;
}

}  // namespace

Cluster cluster_of(const Scene& scene, const Object& root) { return with_carried(scene, {root, {}}); }

const Object& anchor_of(const Scene& scene, const Object& object) {
  if (object.group.empty()) return object;
  const auto first = std::find_if(scene.objects.begin(), scene.objects.end(), [&](const Object& other) {
    return other.group == object.group && other.room == object.room;
  });
  return first == scene.objects.end() ? object : *first;
}

bool is_anchor(const Scene& scene, const Object& object) {
  return !object.group.empty() && anchor_of(scene, object).id == object.id;
}

Cluster whole_of(const Scene& scene, const Object& root) {
  Cluster cluster{root, {}};
  if (is_anchor(scene, root))
    for (const auto& object : scene.objects)
      if (object.group == root.group && object.room == root.room && object.id != root.id && object.on.empty())
        cluster.carried.push_back(object);
  return with_carried(scene, std::move(cluster));
}

Pose pose_of(const Object& object) { return {object.position.head<2>(), object.position.z(), object.yaw}; }

Cluster moved_to(const Cluster& cluster, const Pose& pose) {
  Cluster moved = cluster;
  const Object& old = cluster.root;
  moved.root = at_pose(old, pose);
  const double turn = wrap_angle(moved.root.yaw - old.yaw);
  const double rise = moved.root.position.z() - old.position.z();
  for (auto& object : moved.carried) {
    const Vec2 offset = object.position.head<2>() - old.position.head<2>();
    const Vec2 at = moved.root.position.head<2>() + (turn == 0.0 ? offset : rotated(offset, turn));
    object = at_pose(object, {at, object.position.z() + rise, wrap_angle(object.yaw + turn)});
  }
  return moved;
}

Cluster in_room(Cluster cluster, const std::string& room) {
  cluster.root.room = room;
  for (auto& object : cluster.carried) object.room = room;
  return cluster;
}

void Draft::put(const Cluster& cluster) {
  const auto put_one = [&](const Object& object) {
    if (Object* there = find_object(scene, object.id)) *there = object;
    else scene.objects.push_back(object);
  };
  put_one(cluster.root);
  for (const auto& object : cluster.carried) put_one(object);
}

void Draft::take_out(const std::set<std::string>& ids) {
  std::erase_if(scene.objects, [&](const Object& object) { return ids.count(object.id) > 0; });
}

void Draft::take_over(Draft&& trial) {
  scene = std::move(trial.scene);
  named = std::move(trial.named);
  added = std::move(trial.added);
  repairs = std::move(trial.repairs);
  wishes = std::move(trial.wishes);
  new_categories = std::move(trial.new_categories);
  new_measures = std::move(trial.new_measures);
}

const Room& room_with_id(const Scene& scene, const std::string& id) {
  const Room* room = find_room(scene.rooms, id);
  return room ? *room : scene.room;
}

Room& room_with_id(Scene& scene, const std::string& id) {
  return const_cast<Room&>(room_with_id(std::as_const(scene), id));
}

void restore_order(const std::vector<Object>& before, std::vector<Object>& objects) {
  const auto rank = [&](const Object& object) {
    const auto found =
        std::find_if(before.begin(), before.end(), [&](const Object& one) { return one.id == object.id; });
    return found - before.begin();
  };
  std::stable_sort(objects.begin(), objects.end(), [&](const Object& a, const Object& b) { return rank(a) < rank(b); });
}

Error cannot(const std::string& what) { return {Error::Kind::not_found, what}; }

Result<Object> object_named(const Draft& draft, std::string_view id) {
  if (const Object* object = find_object(draft.scene, id)) return *object;
  std::vector<std::string> ids;
  for (const auto& object : draft.scene.objects) ids.push_back(object.id);
  const std::string near = closest_name(id, ids);
  return cannot("there is no \"" + std::string(id) + "\" in the scene" +
                (near.empty() ? "" : "; did you mean " + near + "?"));
}

bool may_go(const Draft& draft, const Object& object) {
  return !object.locked || draft.shop.kinds().get(object.category).covers_window;
}

Result<Object> object_to_change(Draft& draft, std::string_view id, bool in_place) {
  auto object = object_named(draft, id);
  if (!object) return object;
  if (object->locked && !(in_place && may_go(draft, *object)))
    return cannot(object->id + " is locked; unlock it first");
  draft.named.insert(object->id);
  return object;
}

Result<std::string> room_named(const Draft& draft, const std::string& id) {
  const auto rooms = rooms_of(draft.scene);
  if (rooms.size() == 1) return rooms.front().id;
  std::string known;
  for (const auto& room : rooms) {
    if (room.id == id) return id;
    known += (known.empty() ? "" : ", ") + room.id;
  }
  if (id.empty()) return Error{Error::Kind::not_understood, "say in which room: " + known};
  return cannot("there is no room \"" + id + "\": there are " + known);
}

}  // namespace roomgen
