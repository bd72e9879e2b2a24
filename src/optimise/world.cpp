#include "world.h"

#include <algorithm>
#include <cmath>

namespace roomgen::annealing {

namespace {

constexpr int most_levels = 8;     // of things on each other
constexpr double opening_depth = 0.10;

// As files hold poses: what is tested is what is written.
double rounded_length(double value) { return std::round(value * 1e4) / 1e4; }
double rounded_angle(double value) { return radians(std::round(degrees(wrap_angle(value)) * 1e3) / 1e3); }

Body body_of(const Room& room, const Opening& door) {
  const Segment hole = segment(room, door);
  const Vec2 out = -inward(room, door);
  return {Footprint(hole.middle() + 0.5 * opening_depth * out, {hole.length(), opening_depth}, yaw_facing(-out)),
          door.sill, door.head};
}

// A thing that only hangs against a wall has no other attachment.
Mount mount_of(const Stance& stance) {
  Mount mount = Mount::wall;
  for (const auto& attachment : stance.held()) {
    if (attachment.parent == Face::floor) mount = Mount::floor;
    if (attachment.parent == Face::ceiling) mount = Mount::ceiling;
    if (attachment.parent == Face::top || attachment.parent == Face::support) return Mount::surface;
  }
  return mount;
}

}  // namespace

World::World(const Room& room, const KindTable& kinds, const std::vector<Article>& articles,
             const ModelTable& models, const std::vector<PutUp>& relations)
    : room_(room),
      kinds_(kinds),
      articles_(articles),
      relations_(relations),
      limits_(room),
      solids_(models),
      support_poses_(models),
      items_(most_things),
      empty_grid_(room),
      zones_(most_things) {
  for (const auto& opening : room.openings) {
    if (openings_.size() == static_cast<std::size_t>(most_slots - first_opening_slot)) break;
    const Slot slot = first_opening_slot + static_cast<Slot>(openings_.size());
    (opening.is_entrance() ? doors_ : windows_).insert(slot);
    openings_.push_back(body_of(room, opening));
  }
}

void World::put(Item& item, const Stance& stance) {
  item.stance = stance;
  item.stance.position = {rounded_length(stance.position.x()), rounded_length(stance.position.y())};
  item.stance.bottom = rounded_length(stance.bottom);
  item.stance.yaw = rounded_angle(stance.yaw);
  Object& object = item.object;
  object.mount = mount_of(stance);
  object.position << item.stance.position, item.stance.bottom;
  object.yaw = item.stance.yaw;
  item.body = {footprint(object), bottom(object), top(object)};
  item.version = ++last_version_;
}

void World::dress(Item& item, int article) {
  const Article& worn = articles_[static_cast<std::size_t>(article)];
  item.article = article;
  item.object = worn.object;
  item.kind = worn.kind;
  item.kind_number = worn.kind_number;
}

std::optional<Slot> World::add(int article, const Stance& stance, int bound) {
  const auto free = std::find(items_.begin(), items_.end(), nullptr);
  if (free == items_.end()) return std::nullopt;
  const Slot slot = static_cast<Slot>(free - items_.begin());
  add_at(slot, article, stance, bound);
  return slot;
}

void World::add_at(Slot slot, int article, const Stance& stance, int bound) {
  auto& place = items_[static_cast<std::size_t>(slot)];
  place = std::make_unique<Item>();
  dress(*place, article);
  place->bound = bound;
  put(*place, stance);
  things_.insert(slot);
  disturb(place->body.footprint.bounds());
  changes_.push_back({Change::Kind::added, slot});
  ++structure_;
}

void World::remove(Slot slot) {
  disturb(item(slot).body.footprint.bounds());
  changes_.push_back({Change::Kind::removed, slot});
  changes_.back().item = std::move(items_[static_cast<std::size_t>(slot)]);
  things_.erase(slot);
  ++structure_;
}

void World::set_stance(Slot slot, const Stance& stance) {
  Item& item = at(slot);
  if (!std::ranges::equal(item.stance.held(), stance.held())) ++structure_;
  changes_.push_back({Change::Kind::posed, slot, item.stance, item.body, item.version});
  disturb(item.body.footprint.bounds());
  put(item, stance);
  disturb(item.body.footprint.bounds());
}

void World::set_article(Slot slot, int article) {
  Item& item = at(slot);
  changes_.push_back({Change::Kind::replaced, slot});
  changes_.back().item = std::make_unique<Item>(item);
  const Stance stance = item.stance;
  disturb(item.body.footprint.bounds());
  dress(item, article);
  put(item, stance);
  disturb(item.body.footprint.bounds());
  ++structure_;
}

void World::undo() {
  for (; !changes_.empty(); changes_.pop_back()) {
    Change& change = changes_.back();
    auto& place = items_[static_cast<std::size_t>(change.slot)];
    if (place) disturb(place->body.footprint.bounds());
    switch (change.kind) {
      case Change::Kind::added:
        place.reset();
        things_.erase(change.slot);
        ++structure_;
        break;
      case Change::Kind::removed:
      case Change::Kind::replaced:
        place = std::move(change.item);
        things_.insert(change.slot);
        ++structure_;
        break;
      case Change::Kind::posed:
        if (!std::ranges::equal(place->stance.held(), change.stance.held())) ++structure_;
        place->stance = change.stance;
        place->body = change.body;
        place->version = change.version;
        place->object.position << change.stance.position, change.stance.bottom;
        place->object.yaw = change.stance.yaw;
        break;
    }
    if (place) disturb(place->body.footprint.bounds());
  }
}

const SlotSet& World::supporters() {
  if (supporters_of_ == structure_) return supporters_;
  supporters_ = {};
  supporters_of_ = structure_;
  things_.each([&](Slot slot) {
    for (const auto& attachment : item(slot).stance.held())
      if (attachment.target < most_things) supporters_.insert(attachment.target);
  });
  return supporters_;
}

SlotSet World::cluster(Slot slot) {
  SlotSet members;
  members.insert(slot);
  if (!supporters().has(slot)) return members;
  for (bool grown = true; grown;) {
    grown = false;
    things_.each([&](Slot other) {
      if (members.has(other)) return;
      for (const auto& attachment : item(other).stance.held())
        if (attachment.target < most_things && members.has(attachment.target)) members.insert(other), grown = true;
    });
  }
  return members;
}

World::Freedom World::freedom(int article, std::span<const Attachment> attachments) const {
  const Object& object = articles_[static_cast<std::size_t>(article)].object;
  const Vec2 half = 0.5 * object.size.head<2>();
  std::array<Track, most_attachments> tracks;
  std::size_t count = 0;
  for (const auto& attachment : attachments) {
    if (!is_upright(attachment.parent)) continue;
    const PutUp& how = relation(attachment.relation);
    const auto track = attachment.parent == Face::wall
                           ? track_along_wall(how, attachment, half, room_.polygon)
                           : track_along_side(how, attachment, half, item(attachment.target).body.footprint);
    if (!track) return {false};
    tracks[count++] = *track;
  }
  if (count == 0) return {true};
  auto common = common_track({tracks.data(), count});
  return {common.has_value(), common};
}

bool World::attachments_hold(Slot slot) const {
  const Item& thing = item(slot);
  const Freedom left = freedom(thing.article, thing.stance.held());
  constexpr double tolerance = 1e-3;  // files hold 0.1 mm
  return left.possible && (!left.track || left.track->holds(thing.stance.position, thing.stance.yaw, tolerance));
}

std::optional<Slot> World::carrier(Slot slot) const {
  for (const auto& attachment : item(slot).stance.held())
    if (attachment.parent == Face::top || attachment.parent == Face::support) return attachment.target;
  return std::nullopt;
}

bool World::rests_on(Slot upper, Slot lower) const {
  std::optional<Slot> below = carrier(upper);
  for (int level = 0; level < most_levels && below; ++level, below = carrier(*below))
    if (*below == lower) return true;
  return false;
}

World::Meeting World::meeting(Slot a, Slot b) const {
  const Item &one = item(a), &two = item(b);
  if (!boxes_clash(one.object, one.body.footprint, one.body.bottom, two.object, two.body.footprint))
    return Meeting::apart;
  if (!both_solid(one.object, two.object)) return Meeting::clash;
  const auto sits_over = [&](Slot upper, const Item& other) {
    for (const auto& attachment : item(upper).stance.held())
      if (attachment.target < most_things && is_level(attachment.parent) &&
          tucks(*item(attachment.target).kind, *other.kind))
        return true;
    return false;
  };
  // Within one box two things may still keep out of each other's way.
  const bool may_meet =
      rests_on(a, b) || rests_on(b, a) || tucks(*one.kind, *two.kind) || sits_over(a, two) || sits_over(b, one);
  return may_meet ? Meeting::meshes_decide : Meeting::clash;
}

bool World::boxes_admit(const SlotSet& moved) {
  undecided_.clear();
  bool fits = true;
  moved.each([&](Slot slot) {
    if (!fits) return;
    const Item& thing = item(slot);
    fits = !thing.fixed && limits_.admit(thing.object, *thing.kind, thing.body.footprint, thing.body.bottom) &&
           attachments_hold(slot);
    if (!fits) return;
    things_.each([&](Slot other) {
      if (!fits || other == slot || (moved.has(other) && other < slot)) return;
      const Meeting how = meeting(slot, other);
      fits = how != Meeting::clash;
      if (how == Meeting::meshes_decide) undecided_.push_back({slot, other});
      if (!fits || moved.has(other)) return;
      for (const auto& attachment : item(other).stance.held())
        if (attachment.target == slot) fits = fits && is_upright(attachment.parent) && attachments_hold(other);
    });
  });
  return fits;
}

bool World::meshes_admit() {
  return std::ranges::none_of(undecided_, [&](const auto& pair) {
    return solids_.overlap(item(pair.first).object, item(pair.second).object);
  });
}

void World::disturb(const Bounds2& part) {
  things_.each([&](Slot slot) {
    Zones& zones = zones_[static_cast<std::size_t>(slot)];
    if (zones.is_judged && zones.reach.overlaps(part)) zones.is_judged = false;
  });
}

void World::find_zones(Slot slot) {
  Zones& zones = zones_[static_cast<std::size_t>(slot)];
  const Item& thing = item(slot);
  if (zones.version == thing.version) return;
  zones = {thing.version, {}, {}, {}, false, false};
  const FloorThing own = floor_thing_of(thing);
  if (needs_no_zone(own)) return;
  for (const auto& zone : thing.kind->zones) {
    zones.areas.push_back(zone_footprint(own.footprint, zone));
    zones.inside.push_back(zone_is_free(room_, {}, own, zone));
    zones.reach.add(zones.areas.back().bounds().low);
    zones.reach.add(zones.areas.back().bounds().high);
  }
}

bool World::all_zones_taken(Slot slot) const {
  const Zones& zones = zones_[static_cast<std::size_t>(slot)];
  const Item& thing = item(slot);
  const FloorThing own = floor_thing_of(thing);
  for (std::size_t z = 0; z < zones.areas.size(); ++z) {
    if (!zones.inside[z]) continue;
    bool taken = false;
    things_.each([&](Slot other) {
      if (taken || other == slot || !item(other).body.footprint.bounds().overlaps(zones.areas[z].bounds())) return;
      taken = blocks_zone(floor_thing_of(item(other)), own, thing.kind->zones[z], zones.areas[z]);
    });
    if (!taken) return false;
  }
  return !zones.areas.empty();
}

int World::useless() {
  int count = 0;
  things_.each([&](Slot slot) {
    find_zones(slot);
    Zones& zones = zones_[static_cast<std::size_t>(slot)];
    if (!zones.is_judged) zones.is_useless = all_zones_taken(slot), zones.is_judged = true;
    count += zones.is_useless;
  });
  return count;
}

bool World::is_reachable() const {
  std::vector<FloorThing> things;
  things_.each([&](Slot slot) { things.push_back(floor_thing_of(item(slot))); });
  OccupancyGrid grid = empty_grid_;
  for (const auto& thing : things)
    if (blocks_floor(*thing.object, *thing.category)) grid.add(thing.footprint);
  grid.flood();
  return grid.doors_connected() && std::ranges::all_of(things, [&](const FloorThing& thing) {
           return is_usable(room_, things, thing, grid);
         });
}

}  // namespace roomgen::annealing
