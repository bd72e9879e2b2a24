#include "room_physics.h"

#include <algorithm>
#include <set>

#include "collision/solids.h"
#include "physics.h"

namespace roomgen::lab {

namespace {

// Each thing has a mesh of its own where it stands: so many take about a gigabyte.
constexpr std::size_t most_triangles = 10'000'000;

class RoomPhysics {
 public:
  RoomPhysics(const Scene& scene, const ModelTable& models, const RoomSurfaces& around)
      : scene_(scene), around_(around), solids_(models) {
    std::size_t triangles = 0;
    for (const auto& object : scene.objects) {
      things_.push_back(thing_of(object, triangles < most_triangles ? models : ModelTable()));
      triangles += things_.back().mesh().triangles.size();
      mounts_.push_back(object.mount);
      boxes_.push_back(box_of(object));
    }
  }

  MeasuredRoom run() {
    MeasuredRoom measured;
    RoomScore& score = measured.score;
    score.id = scene_.room.id;
    score.objects = scene_.objects.size();
    score.solids = static_cast<std::size_t>(
        std::count_if(scene_.objects.begin(), scene_.objects.end(),
                      [](const Object& object) { return !object.traits.flat; }));
    find_collisions(score);
    find_unheld(score);
    find_ways(score);
    measured.things = std::move(things_);
    return measured;
  }

 private:
  void find_collisions(RoomScore& score) {
    const auto& objects = scene_.objects;
    std::set<std::size_t> all, among_solids;
    for (std::size_t i = 0; i < objects.size(); ++i)
      for (std::size_t j = i + 1; j < objects.size(); ++j) {
        // Beyond what is looked into, boxes that overlap collide; the pairs are too many to be named.
        if (!boxes_overlap(objects[i], objects[j])) continue;
        if (!crowd_.is_full()) {
          if (!crowd_.add(solids_.intersect(objects[i], objects[j]))) continue;
          score.collisions.emplace_back(objects[i].id, objects[j].id);
        }
        all.insert({i, j});
        if (both_solid(objects[i], objects[j])) among_solids.insert({i, j});
      }
    for (const auto i : all) score.colliding.push_back(objects[i].id);
    for (const auto i : among_solids) score.colliding_solids.push_back(objects[i].id);
  }

  // In a crowd nothing counts as held: rays from each thing to all that it is in the middle of would take minutes.
  void find_unheld(RoomScore& score) const {
    const auto held = crowd_.is_full() ? std::vector<bool>(things_.size(), false)
                                       : sceneeval::supported(things_, mounts_, scene_.room, around_.parts);
    for (std::size_t i = 0; i < things_.size(); ++i) {
      const std::string& id = scene_.objects[i].id;
      if (!held[i]) score.unsupported.push_back(id);
      if (sceneeval::share_in_bounds(things_[i], scene_.room) < sceneeval::least_share_in_bounds)
        score.outside.push_back(id);
    }
  }

  void find_ways(RoomScore& score) const {
    score.navigability = sceneeval::navigability(boxes_, scene_.room);
    const auto before = sceneeval::in_the_way(boxes_, scene_.room);
    for (std::size_t k = 0; k < before.size(); ++k) {
      const Opening& opening = scene_.room.openings[k];
      ++(opening.is_entrance() ? score.doors : score.windows);
      if (before[k].empty()) ++(opening.is_entrance() ? score.clear_doors : score.clear_windows);
      for (const auto i : before[k]) score.in_the_way[opening.id].push_back(scene_.objects[i].id);
    }
  }

  const Scene& scene_;
  const RoomSurfaces& around_;
  Solids solids_;
  Crowd crowd_;
  std::vector<Thing> things_;
  std::vector<Mount> mounts_;
  std::vector<OrientedBox> boxes_;
};

}  // namespace

MeasuredRoom measure_room(const Scene& scene, const ModelTable& models,
                          const RoomSurfaces& around) {
  return RoomPhysics(scene, models, around).run();
}

}  // namespace roomgen::lab
