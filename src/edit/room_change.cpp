#include <algorithm>
#include <map>

#include "draft_changes.h"
#include "placing.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

/// One change of a room, thing by thing.
class RoomChanger {
 public:
  RoomChanger(Draft& draft, const RoomChange& change) : draft_(draft), change_(change), along_(change.along) {}

  Status run() {
    if (auto status = check(change_.room); !status) return cannot(status.error().message);
    remember();
    if (auto status = go_along(); !status) return status;
    const auto misfits = find_misfits();
    if (auto status = may_move(misfits); !status) return status;
    if (auto status = place_again(misfits); !status) return status;
    report();
    return {};
  }

 private:
  void remember() {
    for (const auto& object : draft_.scene.objects) {
      if (object.room != change_.room.id || !object.on.empty()) continue;
      roots_.push_back(object.id);
      before_.emplace(object.id, object);
      held_.emplace(object.id, held_relations(object, object.relations, draft_.scene, draft_.shop.kinds()));
    }
    room_with_id(draft_.scene, change_.room.id) = change_.room;
  }

  Cluster cluster(const std::string& id) const { return whole_of(draft_.scene, *find_object(draft_.scene, id)); }

  void shift(const std::string& id) {
    Pose pose = pose_of(before_.at(id));
    pose.position += change_.by;
    draft_.put(moved_to(cluster(id), pose));
  }

  Status go_along() {
    for (const auto& id : along_) shift(id);
    for (bool grew = !along_.empty(); grew;) {
      grew = false;
      for (const auto& id : roots_)
        if (!along_.count(id) && !before_.at(id).locked && is_left_behind(id)) {
          along_.insert(id);
          shift(id);
          grew = true;
        }
    }
    for (const auto& id : along_)
      if (before_.at(id).locked) return cannot(id + " would go along, and is locked; unlock it first");
    return {};
  }

  // It stood to something that went.
  bool is_left_behind(const std::string& id) const {
    const auto lost = lost_relations(*find_object(draft_.scene, id), held_.at(id), draft_.scene, draft_.shop.kinds());
    return std::any_of(lost.begin(), lost.end(), [&](const Relation& one) {
      return std::any_of(along_.begin(), along_.end(),
                         [&](const std::string& leader) { return cluster(leader).ids().count(one.target) > 0; });
    });
  }

  // Of two things that are in each other's way the one that did not go along has to move.
  std::vector<std::string> find_misfits() {
    std::vector<std::string> misfits;
    std::set<std::string> away;
    for (const bool went_along : {false, true})
      for (const auto& id : roots_) {
        if (static_cast<bool>(along_.count(id)) != went_along || fits(id, away)) continue;
        misfits.push_back(id);
        away.merge(cluster(id).ids());
      }
    std::stable_sort(misfits.begin(), misfits.end(), [&](const std::string& a, const std::string& b) {
      return footprint(before_.at(a)).area() > footprint(before_.at(b)).area();
    });
    return misfits;
  }

  bool fits(const std::string& id, std::set<std::string> away) const {
    const Cluster here = cluster(id);
    away.merge(here.ids());
    Layout& layout = draft_.shop.layout(draft_.scene, change_.room.id, away);
    return settled(draft_, layout, here, RugEdges::stood_on).ok();
  }

  Status may_move(const std::vector<std::string>& misfits) const {
    for (const auto& id : misfits)
      if (before_.at(id).locked) return cannot(id + " stands in the way, and is locked; unlock it first");
    if (draft_.repair || misfits.empty()) return {};
    return cannot(join(misfits, ", ") + (misfits.size() == 1 ? " stands" : " stand") + " in the way");
  }

  Status place_again(const std::vector<std::string>& misfits) {
    std::set<std::string> away;
    for (const auto& id : misfits) away.merge(cluster(id).ids());
    for (const auto& id : misfits) {
      const Cluster here = cluster(id);
      auto place = place_near(here, away);
      if (!place)
        return cannot("there would be no room for " + id + " (" + place.error().message + "); removing it would help");
      place->root.relations = before_.at(id).relations;
      draft_.put(*place);
      for (const auto& placed : here.ids()) away.erase(placed);
    }
    return {};
  }

  // With all relations that held, or else with those that can be kept.
  Result<Cluster> place_near(const Cluster& here, const std::set<std::string>& away) {
    Aim aim;
    aim.asked = held_.at(here.root.id);
    aim.near_to = pose_of(here.root);
    aim.most_off = furthest_way;
    aim.turns_freely = true;
    Layout& layout = draft_.shop.layout(draft_.scene, change_.room.id, away);
    auto place = find_place(draft_, layout, here, aim);
    if (place) return place;
    aim.kept = std::move(aim.asked);
    aim.asked.clear();
    return find_place(draft_, layout, here, aim);
  }

  void report() {
    for (const auto& id : roots_) {
      const Object &was = before_.at(id), &is = *find_object(draft_.scene, id);
      if (was.position == is.position && was.yaw == is.yaw) continue;
      draft_.repairs.push_back({id, was.position, is.position, wrap_angle(is.yaw - was.yaw)});
    }
  }

  Draft& draft_;
  const RoomChange& change_;
  std::set<std::string> along_;
  std::vector<std::string> roots_;  ///< what stands on no other thing, in the scene's order
  std::map<std::string, Object> before_;
  std::map<std::string, std::vector<Relation>> held_;
};

}  // namespace

Status change_room(Draft& draft, const RoomChange& change) { return RoomChanger(draft, change).run(); }

}  // namespace roomgen
