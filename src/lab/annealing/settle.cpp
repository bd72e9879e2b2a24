#include "settle.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "solve/layout.h"

namespace roomgen::lab::annealing {

namespace {

constexpr double neat = 0.3;       // share of draws that take an end or the middle of a stretch
constexpr double snugly = 0.4, snug = 0.005;  // share of draws beside another thing; metres
constexpr double along_walls = 0.5, wall_gap = 0.02;  // of free things that are put there; metres
constexpr double against_others = 0.5, alike = 0.6;  // of the rest, beside another; of these, turned as it is
constexpr double slanted = 0.01;   // share of free things that stand at 45 degrees
constexpr double elevation_deviation = 0.15;  // metres
constexpr int looks = 3;           // places on a carrier that are tried at once
constexpr double place_pitch = 0.05, near_pitch = 0.01;  // metres
constexpr double as_carrier = 0.6; // share of things that look where their carrier looks

Vec2 turned(const Vec2& point, const Vec2& about, double yaw, const Vec2& to) {
  return to + rotated(point - about, yaw);
}

}  // namespace

double Settler::usual_yaw() {
  const Polygon& polygon = world_.room().polygon;
  const auto wall = static_cast<std::size_t>(random_.integer(0, static_cast<int>(polygon.size()) - 1));
  const int quarter = random_.integer(0, 3);
  const double slant = random_.chance(slanted) ? pi / 4 : 0.0;
  return wrap_angle(yaw_facing(polygon.inward(wall)) + quarter * pi / 2 + slant);
}

// The height of the bottom of what stands on the floor or hangs.
double Settler::level(int article, const Stance& stance) {
  const Article& worn = world_.articles()[static_cast<std::size_t>(article)];
  const double height = worn.object.size.z();
  for (const auto& attachment : stance.held()) {
    if (attachment.parent == Face::floor) return 0.0;
    if (attachment.parent == Face::ceiling) return mounting_height(Mount::ceiling, height, 0.0, world_.room());
  }
  const double usual = worn.kind->elevation + random_.normal(0.0, elevation_deviation);
  return mounting_height(Mount::wall, height, std::max(0.0, usual), world_.room());
}

// Where a thing on a track just touches one that stands in its way: floors fill up from their corners.
std::optional<double> Settler::beside_another(const Track& track, const Object& object) {
  const Vec2 along = left_of(track.normal);
  const Footprint own(track.at(track.low), object.size.head<2>(), track.yaw, object.traits.round);
  const double half = reach_along(own, along), across = reach_along(own, track.normal);
  std::vector<double> places;
  world_.things().each([&](Slot slot) {
    const Item& other = world_.item(slot);
    if (other.object.traits.flat || other.object.mount != Mount::floor) return;
    const Footprint& its = other.body.footprint;
    if (std::abs(track.normal.dot(its.center()) - track.offset) > across + reach_along(its, track.normal)) return;
    const double reach = reach_along(its, along) + half + snug;
    for (const double place : {along.dot(its.center()) - reach, along.dot(its.center()) + reach})
      if (place > track.low && place < track.high) places.push_back(place);
  });
  if (places.empty()) return std::nullopt;
  return random_.pick(places);
}

double Settler::place_along(const Track& track, const Object& object) {
  if (random_.chance(snugly))
    if (const auto place = beside_another(track, object)) return *place;
  const double share = random_.chance(neat) ? 0.5 * random_.integer(0, 2) : random_.uniform();
  return track.low + share * (track.high - track.low);
}

// Even what nobody wants at a wall finds most room there.
Stance Settler::along_a_wall(int article, const Stance& stance) {
  const Polygon& polygon = world_.room().polygon;
  const Vec2 half = 0.5 * world_.articles()[static_cast<std::size_t>(article)].object.size.head<2>();
  Attachment back;
  back.child = Face::back, back.parent = Face::wall;
  back.wall = random_.integer(0, static_cast<int>(polygon.size()) - 1);
  static const PutUp close{PutUp::Type::stable_against, {Face::back}, {Face::wall}, wall_gap, true};
  Stance there = stance;
  there.yaw = usual_yaw();
  const auto track = track_along_wall(close, back, half, polygon);
  if (!track) return there;
  there.position = track->at(place_along(*track, world_.articles()[static_cast<std::size_t>(article)].object));
  there.yaw = track->yaw;
  return there;
}

// Touching another thing, in line with it at an end or in the middle: rows, and what stands back to back, fill
// floors best.
std::optional<Stance> Settler::against_another(int article, const Stance& stance) {
  std::vector<Slot> others;
  world_.things().each([&](Slot slot) {
    const Object& object = world_.item(slot).object;
    if (object.mount == Mount::floor && !object.traits.flat) others.push_back(slot);
  });
  if (others.empty()) return std::nullopt;
  const Footprint& its = world_.body(random_.pick(others)).footprint;
  const Object& object = world_.articles()[static_cast<std::size_t>(article)].object;
  Stance there = stance;
  const int turn = random_.chance(alike) ? 0 : random_.chance(alike) ? 2 : random_.chance(0.5) ? 1 : 3;
  there.yaw = wrap_angle(its.yaw() + turn * pi / 2);
  const Vec2 towards = rotated(its.x_axis(), random_.integer(0, 3) * pi / 2), along = left_of(towards);
  const Footprint own(Vec2::Zero(), object.size.head<2>(), there.yaw, object.traits.round);
  const double away = reach_along(its, towards) + reach_along(own, towards) + snug;
  const double shift = random_.integer(-1, 1) * (reach_along(its, along) - reach_along(own, along));
  there.position = its.center() + away * towards + shift * along;
  return there;
}

// A random place on one of the surfaces, the larger ones oftener, on a coarse grid so that what was found of a place
// can be used again.
SupportPoses::Place Settler::any_place(std::span<const SupportSurface> surfaces) {
  std::vector<double> areas;
  for (const auto& surface : surfaces) areas.push_back(surface.area);
  const SupportSurface& surface = surfaces[random_.weighted(areas)];
  const Vec2 size = surface.box().size();
  SupportPoses::Place place;
  for (int axis = 0; axis < 2; ++axis) {
    const int cells = std::max(1, static_cast<int>(size[axis] / place_pitch));
    place.position[axis] = surface.low[axis] + size[axis] * (random_.integer(0, cells - 1) + 0.5) / cells;
  }
  place.yaw = random_.chance(as_carrier) ? 0.0 : wrap_angle(random_.integer(1, 3) * pi / 2);
  return place;
}

std::optional<Stance> Settler::on_carrier(int article, const Stance& wanted, bool anywhere) {
  const auto level = std::ranges::find_if(wanted.held(), [](const Attachment& attachment) {
    return attachment.parent == Face::top || attachment.parent == Face::support;
  });
  const Item& carrier = world_.item(level->target);
  const Object& object = world_.articles()[static_cast<std::size_t>(article)].object;
  const auto freedom = world_.freedom(article, wanted.held());
  const SupportPoses& poses = world_.support_poses();
  const auto& surfaces = poses.surfaces(carrier.object);
  if (!freedom.possible || surfaces.empty()) return std::nullopt;
  const auto may_be = [&](const SupportPose& pose) {
    return level->parent == Face::support || surfaces[pose.surface].clearance == SupportSurface::open;
  };
  // The pose at a place that is nearest in height to what is wanted; any, if anything will do.
  const auto stance_at = [&](const SupportPoses::Place& place) {
    std::optional<Stance> best;
    std::vector<SupportPose> found = poses.at(object, carrier.object, {&place, 1});
    std::erase_if(found, [&](const SupportPose& pose) { return !may_be(pose); });
    if (found.empty()) return best;
    const SupportPose pose =
        anywhere ? random_.pick(found) : *std::ranges::min_element(found, {}, [&](const SupportPose& p) {
          return std::abs(bottom(carrier.object) + p.bottom - wanted.bottom);
        });
    const Pose there = pose_of(pose, carrier.object);
    best = wanted;
    best->position = there.position, best->bottom = there.bottom, best->yaw = there.yaw, best->rest = pose;
    return best;
  };
  if (freedom.track) {
    const Track& track = *freedom.track;
    const double reach = 0.5 * carrier.object.size.head<2>().norm();
    const double middle = track.along(carrier.body.footprint.center());
    const double low = std::max(track.low, middle - reach), high = std::min(track.high, middle + reach);
    if (low > high) return std::nullopt;
    const double along = anywhere ? (random_.chance(neat) ? std::clamp(middle, low, high) : random_.uniform(low, high))
                                  : std::clamp(track.along(wanted.position), low, high);
    return stance_at({carrier.body.footprint.to_local(track.at(along)), wrap_angle(track.yaw - carrier.object.yaw)});
  }
  if (!anywhere) {
    const double quarter = std::round(wrap_angle(wanted.yaw - carrier.object.yaw) / (pi / 2)) * (pi / 2);
    const Vec2 local = carrier.body.footprint.to_local(wanted.position);
    const Vec2 place = near_pitch * (local / near_pitch).array().round().matrix();
    return stance_at({place, wrap_angle(quarter)});
  }
  for (int look = 0; look < looks; ++look)
    if (auto stance = stance_at(any_place(surfaces))) return stance;
  return std::nullopt;
}

std::optional<Stance> Settler::anywhere(int article, std::span<const Attachment> attachments) {
  Stance stance;
  std::ranges::copy(attachments, stance.attachments.begin());
  stance.count = attachments.size();
  const auto stands_on = [](const Attachment& a) { return a.parent == Face::top || a.parent == Face::support; };
  if (std::ranges::any_of(attachments, stands_on)) return on_carrier(article, stance, true);
  const auto freedom = world_.freedom(article, attachments);
  if (!freedom.possible) return std::nullopt;
  stance.bottom = level(article, stance);
  if (freedom.track) {
    const Track& track = *freedom.track;
    stance.position = track.at(place_along(track, world_.articles()[static_cast<std::size_t>(article)].object));
    stance.yaw = track.yaw;
    return stance;
  }
  if (random_.chance(along_walls)) return along_a_wall(article, stance);
  if (random_.chance(against_others))
    if (const auto there = against_another(article, stance)) return there;
  const Bounds2 box = bounds(world_.room().polygon);
  stance.position.x() = random_.uniform(box.low.x(), box.high.x());
  stance.position.y() = random_.uniform(box.low.y(), box.high.y());
  if (random_.chance(0.5 * neat)) stance.position = 0.5 * (box.low + box.high);
  stance.yaw = usual_yaw();
  return stance;
}

std::optional<Stance> Settler::near(int article, const Stance& wanted) {
  const auto stands_on = [](const Attachment& a) { return a.parent == Face::top || a.parent == Face::support; };
  if (std::ranges::any_of(wanted.held(), stands_on)) return on_carrier(article, wanted, false);
  const auto freedom = world_.freedom(article, wanted.held());
  if (!freedom.possible) return std::nullopt;
  Stance stance = wanted;
  if (freedom.track) {
    const Track& track = *freedom.track;
    stance.position = track.at(std::clamp(track.along(wanted.position), track.low, track.high));
    stance.yaw = track.yaw;
  }
  for (const auto& attachment : stance.held())
    if (is_level(attachment.parent)) stance.bottom = level(article, stance);
  const double height = world_.articles()[static_cast<std::size_t>(article)].object.size.z();
  stance.bottom = std::clamp(stance.bottom, 0.0, std::max(0.0, world_.room().height - height));
  return stance;
}

std::optional<Stance> Settler::carried(Slot slot, const Stance& moved) {
  const Item& thing = world_.item(slot);
  if (const auto carrier = world_.carrier(slot)) {
    // What stands on a thing keeps its place there as long as the thing is the same.
    const Pose there = pose_of(*thing.stance.rest, world_.item(*carrier).object);
    Stance stance = moved;
    stance.position = there.position, stance.bottom = there.bottom, stance.yaw = there.yaw;
    return stance;
  }
  Stance stance = moved;
  stance.bottom = thing.stance.bottom;
  const auto freedom = world_.freedom(thing.article, stance.held());
  if (!freedom.possible) return std::nullopt;
  if (!freedom.track) return stance;
  stance.position = freedom.track->at(
      std::clamp(freedom.track->along(stance.position), freedom.track->low, freedom.track->high));
  stance.yaw = freedom.track->yaw;
  return stance;
}

std::optional<SlotSet> Settler::carry(Slot root, const Stance& before, const Body& body_before) {
  SlotSet moved, waiting = world_.cluster(root);
  waiting.erase(root);
  moved.insert(root);
  const Stance& after = world_.item(root).stance;
  const double turn = after.yaw - before.yaw;
  while (!waiting.empty()) {
    SlotSet ready;
    waiting.each([&](Slot slot) {
      for (const auto& attachment : world_.item(slot).stance.held())
        if (attachment.target < most_things && waiting.has(attachment.target)) return;
      ready.insert(slot);
    });
    if (ready.empty()) return std::nullopt;  // things against each other in a circle
    bool fits = true;
    ready.each([&](Slot slot) {
      if (!fits) return;
      Stance stance = world_.item(slot).stance;
      stance.position = turned(stance.position, body_before.footprint.center(), turn, after.position);
      stance.yaw = wrap_angle(stance.yaw + turn);
      const auto there = carried(slot, stance);
      fits = there.has_value();
      if (fits) world_.set_stance(slot, *there);
      waiting.erase(slot);
      moved.insert(slot);
    });
    if (!fits) return std::nullopt;
  }
  return moved;
}

}  // namespace roomgen::lab::annealing
