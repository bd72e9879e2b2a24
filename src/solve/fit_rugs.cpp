#include "fit_rugs.h"

#include <algorithm>
#include <map>
#include <set>

#include "collision/low_parts.h"
#include "layout.h"
#include "rug_place.h"

namespace roomgen {

namespace {

constexpr double over_rug = 0.005;  // what is lower than this over a rug's top meets it
constexpr int most_rounds = 8;
constexpr int most_carried = 8;  // levels of things on things

bool is_rug(const Object& object) { return object.traits.flat && object.mount == Mount::floor; }

bool stands_on_floor(const Object& object) {
  return object.mount == Mount::floor && !object.traits.flat;
}

/// The room's things while its rugs are fitted.
class RugFitting {
 public:
  RugFitting(const Room& room, const std::vector<Object>& objects, const ModelTable& models,
             const KindTable& kinds, std::span<const RugWish> wishes)
      : room_(room), first_(objects), models_(models), kinds_(kinds), wishes_(wishes),
        solids_(models), layout_(room, kinds, models) {}

  /// Where lifting a thing onto a rug makes it collide, the rug has to do without that thing.
  RugFit run(std::vector<Object>& objects) {
    for (int round = 0; round < most_rounds; ++round) {
      objects_ = first_;
      fit_ = {};
      lay_all();
      lift_all();
      if (bar_what_cannot_be_lifted()) continue;
      break;
    }
    note_uneven();
    objects = std::move(objects_);
    return std::move(fit_);
  }

 private:
  RugWish wish_of(const std::string& id) const {
    for (const auto& wish : wishes_)
      if (wish.id == id) return wish;
    return {id};
  }

  const std::vector<Footprint>& parts_of(const Object& thing, double height) {
    const auto key = std::pair(thing.id, height);
    const auto known = parts_.find(key);
    if (known != parts_.end()) return known->second;
    return parts_[key] = low_parts(thing, models_, height);
  }

  // All that a rug may meet: things that stand on the floor or come down to it, and rugs that are not
  // under it.
  std::vector<LowThing> things_about(const Object& rug) {
    const Bounds2 near = footprint(rug).bounds();
    std::vector<LowThing> things;
    for (const auto& other : objects_) {
      if (other.id == rug.id || other.mount == Mount::surface ||
          !footprint(other).bounds().overlaps(near, rug.size.head<2>().maxCoeff()))
        continue;
      const Footprint lies = footprint(rug), own = footprint(other);
      if (is_rug(other) && may_lie_over(lies, own)) continue;
      LowThing thing{&other, {own}, is_rug(other) && may_lie_over(own, lies)};
      if (thing.may_be_lifted) thing.parts = {core_of_rug(own)};
      if (!is_rug(other)) {
        thing.parts = parts_of(other, low_over(rug));
        thing.may_be_lifted = stands_on_floor(other) && !barred_.count({other.id, rug.id});
      }
      things.push_back(std::move(thing));
    }
    return things;
  }

  void lay_all() {
    std::vector<std::string> rugs;
    for (const auto& object : objects_)
      if (is_rug(object) && !object.locked) rugs.push_back(object.id);
    for (const auto& id : rugs) lay(id);
  }

  void lay(const std::string& id) {
    const auto rug = std::find_if(objects_.begin(), objects_.end(),
                                  [&](const Object& object) { return object.id == id; });
    const RugWish wish = wish_of(id);
    auto place = rug_place(*rug, wish, room_, objects_, things_about(*rug), kinds_);
    if (place && is_free_of_rugs(*place)) {
      *rug = *std::move(place);
    } else if (!wish.asked) {
      objects_.erase(rug);
      for (auto& other : objects_)
        std::erase_if(other.relations, [&](const Relation& one) { return one.target == id; });
      fit_.left_out.push_back(id);
    }
  }

  bool is_free_of_rugs(const Object& rug) const {
    return std::none_of(objects_.begin(), objects_.end(), [&](const Object& other) {
      return other.id != rug.id && is_rug(other) &&
             boxes_clash(rug, footprint(rug), bottom(rug), other, footprint(other));
    });
  }

  RugStand stand(const Object& thing, const Object& rug) {
    return stand_of(parts_of(thing, low_over(rug)), footprint(rug));
  }

  // What carries a thing in the end: itself where it stands on the floor.
  const Object& root_of(const Object& object) const {
    const Object* at = &object;
    for (int level = 0; level < most_carried && !at->on.empty(); ++level) {
      const Object* below = find_object(first_, at->on);
      if (!below) break;
      at = below;
    }
    return *at;
  }

  void lift_all() {
    lifted_.clear();
    pile_rugs(objects_);
    for (const auto& rug : objects_) {
      if (!is_rug(rug)) continue;
      for (const auto& thing : objects_)
        if (stands_on_floor(thing) && !barred_.count({thing.id, rug.id}) &&
            stand(thing, rug) == RugStand::on && top(rug) > lifted_[thing.id].height)
          lifted_[thing.id] = {rug.id, top(rug)};
    }
    for (auto& object : objects_)
      if (const auto root = lifted_.find(root_of(object).id); root != lifted_.end()) {
        object.position.z() += root->second.height;
        object = with_rounded_pose(std::move(object));
      }
  }

  double height_of(const Object& object) const {
    const auto root = lifted_.find(root_of(object).id);
    return root == lifted_.end() ? 0.0 : root->second.height;
  }

  bool may_be_so_high(const Object& object) {
    if (!layout_.fits_room(layout_.candidate(object), footprint(object), bottom(object))) return false;
    return std::none_of(objects_.begin(), objects_.end(), [&](const Object& other) {
      return height_of(other) != height_of(object) && solids_.overlap(object, other);
    });
  }

  bool bar_what_cannot_be_lifted() {
    const auto count = barred_.size();
    for (const auto& object : objects_) {
      const auto root = lifted_.find(root_of(object).id);
      if (root != lifted_.end() && !may_be_so_high(object))
        barred_.insert({root->first, root->second.rug});
    }
    return barred_.size() > count;
  }

  void note_uneven() {
    for (const auto& rug : objects_) {
      if (!is_rug(rug)) continue;
      const bool even = std::all_of(objects_.begin(), objects_.end(), [&](const Object& thing) {
        if (!stands_on_floor(thing)) return true;
        const RugStand how = stand(thing, rug);
        return how == RugStand::beside || (how == RugStand::on && lifted_.count(thing.id) > 0);
      });
      if (!even) fit_.uneven.push_back(rug.id);
    }
  }

  struct Lift {
    std::string rug;
    double height = 0.0;
  };

  const Room& room_;
  const std::vector<Object> first_;
  const ModelTable& models_;
  const KindTable& kinds_;
  std::span<const RugWish> wishes_;
  Solids solids_;
  Layout layout_;  // of the room alone
  std::vector<Object> objects_;
  RugFit fit_;
  std::map<std::string, Lift> lifted_;                      // what stands on a rug
  std::set<std::pair<std::string, std::string>> barred_;    // things from rugs
  std::map<std::pair<std::string, double>, std::vector<Footprint>> parts_;  // of things on the bare floor
};

}  // namespace

double height_of_rug(const Object& rug, std::span<const Object> objects) {
  double height = 0.0;
  for (const auto& other : objects)
    if (other.id != rug.id && is_rug(other) && may_lie_over(footprint(rug), footprint(other)))
      height = std::max(height, top(other));
  return height;
}

void pile_rugs(std::span<Object> objects) {
  std::vector<Object*> rugs;
  for (auto& object : objects)
    if (is_rug(object)) rugs.push_back(&object);
  std::stable_sort(rugs.begin(), rugs.end(), [](const Object* a, const Object* b) {
    return footprint(*a).area() > footprint(*b).area();
  });
  for (Object* rug : rugs) {
    rug->position.z() = height_of_rug(*rug, objects);
    *rug = with_rounded_pose(std::move(*rug));
  }
}

double low_over(const Object& rug) { return rug.size.z() + over_rug; }

RugStand stand_to_rug(const Object& thing, const Object& rug, const ModelTable& models) {
  Object on_floor = thing;
  on_floor.position.z() = bottom(rug);
  return stand_of(low_parts(on_floor, models, top(rug) + over_rug), footprint(rug));
}

RugFit fit_rugs(const Room& room, std::vector<Object>& objects, const ModelTable& models,
                const KindTable& kinds, std::span<const RugWish> wishes) {
  if (std::none_of(objects.begin(), objects.end(), is_rug)) return {};
  return RugFitting(room, objects, models, kinds, wishes).run(objects);
}

}  // namespace roomgen
