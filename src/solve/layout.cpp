#include "layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "trials.h"

namespace roomgen {

namespace {

constexpr int most_levels = 8;  // of things on each other

std::vector<double> yaws_of_walls(const Room& room) {
  std::vector<double> yaws;
  for (std::size_t k = 0; k < room.polygon.size(); ++k)
    for (int quarter = 0; quarter < 4; ++quarter) {
      const double yaw = wrap_angle(yaw_facing(room.polygon.inward(k)) + quarter * pi / 2);
      const bool known = std::any_of(yaws.begin(), yaws.end(), [&](double other) {
        return std::abs(wrap_angle(other - yaw)) < 1e-6;
      });
      if (!known) yaws.push_back(yaw);
    }
  // Rounded so that right angles are exact and equal rooms give equal files.
  for (auto& yaw : yaws) yaw = radians(std::round(degrees(yaw) * 1e6) / 1e6);
  std::sort(yaws.begin(), yaws.end());
  return thinned(std::move(yaws));
}

}  // namespace

Object at_pose(const Object& object, const Pose& pose) {
  Object placed = object;
  placed.position = {pose.position.x(), pose.position.y(), pose.bottom};
  placed.yaw = pose.yaw;
  return with_rounded_pose(std::move(placed));
}

double mounting_height(Mount mount, double height, double elevation, const Room& room) {
  constexpr double below_ceiling = 0.05;
  const double room_left = std::max(0.0, room.height - height);
  if (mount == Mount::ceiling) return room_left;
  if (mount == Mount::wall) return std::min(elevation, std::max(0.0, room_left - below_ceiling));
  return 0.0;
}

Pose pose_of(const SupportPose& support_pose, const Object& support) {
  return {footprint(support).to_world(support_pose.position), bottom(support) + support_pose.bottom,
          wrap_angle(support.yaw + support_pose.yaw)};
}

Footprint FootprintAt::operator()(const Pose& pose) const {
  for (const auto& known : turned_)
    if (known.yaw() == pose.yaw) return known.moved_to(pose.position);
  constexpr std::size_t most_remembered = 16;
  if (turned_.size() == most_remembered) turned_.clear();
  turned_.emplace_back(Vec2::Zero(), size_, pose.yaw, round_);
  return turned_.back().moved_to(pose.position);
}

Layout::Layout(const Room& room, const KindTable& categories, const ModelTable& models,
               const Arrangements* arrangements, const Weights& weights)
    : room_(room),
      categories_(categories),
      models_(models),
      arrangements_(arrangements),
      weights_(weights),
      solids_(models),
      support_poses_(models),
      wall_yaws_(yaws_of_walls(room)),
      limits_(room),
      occupancy_(room) {
  occupancy_.flood();
  has_way_in_ = occupancy_.doors_connected();
}

const Object* Layout::find(std::string_view id) const {
  return find_object(objects_, id);
}

std::vector<Pose> Layout::free_support_poses(const Object& object, const Object& support) const {
  Object resting = object;
  resting.mount = Mount::surface;
  resting.on = support.id;
  const Candidate own = candidate(resting);
  const FootprintAt footprint_at(object);
  std::vector<Pose> poses;
  for (const auto& support_pose : support_poses_.everywhere(object, support)) {
    const Pose pose = pose_of(support_pose, support);
    if (fits(own, footprint_at(pose), pose.bottom)) poses.push_back(pose);
  }
  return poses;
}

bool Layout::carries_something(std::string_view id) const {
  return std::any_of(objects_.begin(), objects_.end(),
                     [&](const Object& object) { return object.on == id; });
}

const Arrangement* Layout::arrangement_of(const PlacementTask& task) const {
  if (!arrangements_) return nullptr;
  const auto found = arrangements_->compositions.find(task.composition);
  return found == arrangements_->compositions.end() ? arrangement_of(task.object) : &found->second;
}

const Arrangement* Layout::arrangement_of(const Object& object) const {
  return arrangements_ ? &arrangements_->get(categories_, object.category, object.mount) : nullptr;
}

void Layout::refresh_things() {
  for (std::size_t i = 0; i < objects_.size(); ++i) things_[i].object = &objects_[i];
}

void Layout::add(Object object) {
  things_.push_back(floor_thing(object, categories_));
  arranged_.push_back(arrangement_of(object));
  objects_.push_back(std::move(object));
  in_occupancy_.push_back(false);
  refresh_things();
  free_zones_.add(room_, things_);
}

void Layout::remove(std::string_view id) {
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    if (objects_[i].id != id) continue;
    const auto at = static_cast<std::ptrdiff_t>(i);
    if (in_occupancy_[i]) occupancy_.remove(things_[i].footprint);
    free_zones_.remove(things_, i);
    objects_.erase(objects_.begin() + at);
    things_.erase(things_.begin() + at);
    arranged_.erase(arranged_.begin() + at);
    in_occupancy_.erase(in_occupancy_.begin() + at);
    break;
  }
  refresh_things();
}

void Layout::clear() {
  while (!objects_.empty()) remove(objects_.back().id);
}

void Layout::bring_occupancy_up_to_date() {
  for (std::size_t i = 0; i < objects_.size(); ++i)  // things_ may hold a newcomer more
    if (!in_occupancy_[i] && blocks_floor(objects_[i], *things_[i].category)) {
      occupancy_.add(things_[i].footprint);
      in_occupancy_[i] = true;
    }
}

Layout::Candidate Layout::candidate(const Object& object) const {
  return {object, &categories_.get(object.category)};
}

Layout::Candidate Layout::candidate(const PlacementTask& task) const {
  Candidate whole = candidate(task.object);
  for (const auto& companion : task.companions)
    whole.companions.push_back({candidate(companion.object), companion.position, companion.yaw});
  return whole;
}

bool Layout::may_tuck(const Kind& a, const Kind& b) const {
  return !models_.empty() && tucks(a, b);
}

// Also by way of what stands between: books on a tray on a table.
bool Layout::rests_on(const Object& upper, const Object& lower) const {
  const Object* at = &upper;
  for (int level = 0; level < most_levels && at && !at->on.empty(); ++level) {
    if (at->on == lower.id) return true;
    at = find(at->on);
  }
  return false;
}

// The back of a chair at a table rises beside what is on the table, within one box with it.
bool Layout::may_sit_over(const Object& object, const Kind& other) const {
  const Object* support = object.mount == Mount::surface ? find(object.on) : nullptr;
  return support && may_tuck(other, categories_.get(support->category));
}

static bool hangs(const Object& object) {
  return object.mount == Mount::ceiling || object.mount == Mount::wall;
}

bool Layout::fits_room(const Candidate& candidate, const Footprint& footprint,
                       double bottom) const {
  return limits_.admit(candidate.object, *candidate.category, footprint, bottom);
}

bool Layout::collides(const Candidate& candidate, const Footprint& footprint, double bottom,
                      const FloorThing& other) const {
  const Object& object = candidate.object;
  if (!boxes_clash(object, footprint, bottom, *other.object, other.footprint)) return false;
  if (!both_solid(object, *other.object)) return true;
  // An arch over a table, a pipe behind a pillar: of what hangs the meshes decide.
  const bool by_meshes = candidate.by_meshes || hangs(object) || hangs(*other.object);
  if (by_meshes && !models_.empty()) return false;
  // What stands on a thing may sink below the top of its box: the meshes decide.
  return !rests_on(object, *other.object) && !rests_on(*other.object, object) &&
         !may_tuck(*candidate.category, *other.category) &&
         !may_sit_over(object, *other.category) && !may_sit_over(*other.object, *candidate.category);
}

bool Layout::fits(const Candidate& candidate, const Footprint& footprint, double bottom) const {
  return fits_alone(candidate, footprint, bottom) &&
         std::all_of(candidate.companions.begin(), candidate.companions.end(), [&](const auto& companion) {
           const Object& object = companion.self.object;
           const Footprint own(footprint.to_world(companion.position), object.size.head<2>(),
                               wrap_angle(footprint.yaw() + companion.yaw), object.traits.round);
           return fits_alone(companion.self, own, object.position.z()) &&
                  (object.mount != Mount::wall || limits_.is_at_wall(own));
         });
}

bool Layout::fits_alone(const Candidate& candidate, const Footprint& footprint, double bottom) const {
  return fits_room(candidate, footprint, bottom) &&
         std::none_of(things_.begin(), things_.end(), [&](const FloorThing& other) {
           return collides(candidate, footprint, bottom, other);
         });
}

// One after the other, each beside those before it; in the end nothing of them stands.
Layout::Verdict Layout::fits_exactly(const Candidate& whole) {
  Verdict verdict = fits_alone_exactly(whole);
  if (!verdict || whole.companions.empty()) return verdict;
  PlacementTask task;
  for (const auto& one : whole.companions)
    task.companions.push_back({one.self.object, one.position, one.yaw});
  const std::size_t before = objects_.size();
  add(whole.object);
  for (const auto& object : companions_of(task, whole.object)) {
    Candidate companion = candidate(object);
    companion.even_useless = whole.even_useless;
    verdict = fits_alone_exactly(companion);
    if (!verdict) break;
    add(object);
  }
  while (objects_.size() > before) remove(std::string(objects_.back().id));
  std::erase_if(verdict.blamed, [&](std::size_t i) { return i >= before; });
  return verdict;
}

Layout::Verdict Layout::fits_alone_exactly(const Candidate& candidate) {
  const Object& object = candidate.object;
  const Footprint own = footprint(object);
  for (std::size_t i = 0; i < things_.size(); ++i)
    if (solids_.overlap(object, *things_[i].object)) return {false, {i}};
  if (!blocks_floor(object, *candidate.category)) return {};

  things_.push_back({&object, candidate.category, own});
  Verdict verdict = candidate.even_useless ? Verdict() : all_have_a_free_zone();
  if (verdict) verdict = all_are_usable_with(own, candidate.even_useless);
  things_.pop_back();
  return verdict;
}

// Whether the i-th thing has a free zone beside the newcomer, the last of things_, or is that itself.
bool Layout::keeps_free_zone(std::size_t i) const {
  if (i == objects_.size()) return has_free_zone(room_, things_, things_[i]);
  return free_zones_.has_lost_all(i) ||
         free_zones_.has_free(things_[i], i, things_.back(), [](const Footprint&) { return true; });
}

bool Layout::is_usable_still(std::size_t i) const {
  if (i == objects_.size()) return is_usable(room_, things_, things_[i], occupancy_);
  return free_zones_.has_lost_all(i) ||
         free_zones_.has_free(things_[i], i, things_.back(),
                              [&](const Footprint& area) { return occupancy_.reaches(area); });
}

// Cheaper than the walk, and what most bad poses fail.
Layout::Verdict Layout::all_have_a_free_zone() const {
  for (std::size_t i = 0; i < things_.size(); ++i)
    if (!keeps_free_zone(i)) return blame(i);
  return {};
}

Layout::Verdict Layout::all_are_usable_with(const Footprint& newcomer, bool even_useless) {
  bring_occupancy_up_to_date();
  occupancy_.add(newcomer);
  occupancy_.flood();
  Verdict verdict;
  if (!occupancy_.doors_connected()) verdict = {false};
  for (std::size_t i = 0; i < things_.size() && verdict && !even_useless; ++i)
    if (!is_usable_still(i)) verdict = blame(i);
  occupancy_.remove(newcomer);
  return verdict;
}

// A thing that the newcomer, the last of things_, makes useless could stand elsewhere; for a
// newcomer that is useless itself, those in its zones could.
Layout::Verdict Layout::blame(std::size_t useless) const {
  const std::size_t newcomer = things_.size() - 1;
  if (useless != newcomer) return {false, {useless}, useless};
  Verdict verdict{false, {}, useless};
  const FloorThing& own = things_.back();
  for (std::size_t i = 0; i < newcomer; ++i) {
    const auto stands_in = [&](const UseZone& zone) {
      return blocks_zone(things_[i], own, zone, zone_footprint(own.footprint, zone));
    };
    if (std::any_of(own.category->zones.begin(), own.category->zones.end(), stands_in))
      verdict.blamed.push_back(i);
  }
  return verdict;
}

}  // namespace roomgen
