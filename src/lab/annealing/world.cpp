#include "world.h"

#include <algorithm>
#include <cmath>

namespace roomgen::lab::annealing {

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
      zones_(most_things),
      walkways_(room),
      obstacles_(most_things) {
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
  judged_.erase(slot);
  disturb(place->body.footprint.bounds());
  changes_.push_back({Change::Kind::added, slot});
  change_structure();
}

void World::remove(Slot slot) {
  judged_.erase(slot);
  disturb(item(slot).body.footprint.bounds());
  changes_.push_back({Change::Kind::removed, slot});
  changes_.back().item = std::move(items_[static_cast<std::size_t>(slot)]);
  things_.erase(slot);
  change_structure();
}

void World::set_stance(Slot slot, const Stance& stance) {
  Item& item = at(slot);
  if (!std::ranges::equal(item.stance.held(), stance.held())) change_structure();
  changes_.push_back({Change::Kind::posed, slot, item.stance, item.body, item.version});
  judged_.erase(slot);
  disturb(item.body.footprint.bounds());
  put(item, stance);
  disturb(item.body.footprint.bounds());
}

void World::set_article(Slot slot, int article) {
  Item& item = at(slot);
  changes_.push_back({Change::Kind::replaced, slot});
  changes_.back().item = std::make_unique<Item>(item);
  const Stance stance = item.stance;
  judged_.erase(slot);
  disturb(item.body.footprint.bounds());
  dress(item, article);
  put(item, stance);
  disturb(item.body.footprint.bounds());
  change_structure();
}

void World::mark() {
  changes_.clear();
  marked_ = {structure_, judged_, useless_};
}

// With the old poses all that was known of them holds again.
void World::undo() {
  for (; !changes_.empty(); changes_.pop_back()) {
    Change& change = changes_.back();
    auto& place = items_[static_cast<std::size_t>(change.slot)];
    switch (change.kind) {
      case Change::Kind::added:
        place.reset();
        things_.erase(change.slot);
        break;
      case Change::Kind::removed:
      case Change::Kind::replaced:
        place = std::move(change.item);
        things_.insert(change.slot);
        break;
      case Change::Kind::posed:
        place->stance = change.stance;
        place->body = change.body;
        place->version = change.version;
        place->object.position << change.stance.position, change.stance.bottom;
        place->object.yaw = change.stance.yaw;
        break;
    }
  }
  structure_ = marked_.structure;
  judged_ = marked_.judged, useless_ = marked_.useless;
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

SlotSet World::clashing(Slot slot) {
  SlotSet found;
  things_.each([&](Slot other) {
    if (other == slot) return;
    const Meeting how = meeting(slot, other);
    const bool clashes =
        how == Meeting::clash || (how == Meeting::meshes_decide && solids_.overlap(item(slot).object, item(other).object));
    if (clashes) found.insert(other);
  });
  return found;
}

void World::disturb(const Bounds2& part) {
  judged_.each([&](Slot slot) {
    find_zones(slot);  // a move that was taken back leaves those of another pose
    if (zones_[static_cast<std::size_t>(slot)].reach.overlaps(part)) judged_.erase(slot);
  });
}

void World::find_zones(Slot slot) {
  Zones& zones = zones_[static_cast<std::size_t>(slot)];
  const Item& thing = item(slot);
  if (zones.version == thing.version) return;
  zones = {thing.version, {}, {}, {}};
  const FloorThing own = floor_thing_of(thing);
  if (needs_no_zone(own)) return;
  for (const auto& zone : thing.kind->zones) {
    zones.areas.push_back(zone_footprint(own.footprint, zone));
    zones.inside.push_back(zone_is_free(room_, {}, own, zone));
    zones.reach.add(zones.areas.back().bounds().low);
    zones.reach.add(zones.areas.back().bounds().high);
  }
}

bool World::is_zone_free(Slot slot, std::size_t zone) const {
  const Zones& zones = zones_[static_cast<std::size_t>(slot)];
  if (!zones.inside[zone]) return false;
  const Item& thing = item(slot);
  const FloorThing own = floor_thing_of(thing);
  const Footprint& area = zones.areas[zone];
  bool taken = false;
  things_.each([&](Slot other) {
    if (taken || other == slot || !item(other).body.footprint.bounds().overlaps(area.bounds())) return;
    taken = blocks_zone(floor_thing_of(item(other)), own, thing.kind->zones[zone], area);
  });
  return !taken;
}

bool World::all_zones_taken(Slot slot) const {
  const std::size_t count = zones_[static_cast<std::size_t>(slot)].areas.size();
  for (std::size_t zone = 0; zone < count; ++zone)
    if (is_zone_free(slot, zone)) return false;
  return count > 0;
}

int World::useless() {
  things_.each([&](Slot slot) {
    if (judged_.has(slot)) return;
    find_zones(slot);
    judged_.insert(slot);
    useless_.erase(slot);
    if (all_zones_taken(slot)) useless_.insert(slot);
  });
  SlotSet useless = useless_;
  useless &= things_;
  return useless.size();
}

// Stamps what has come, gone or moved since the last time.
void World::map_walkways() {
  for (Slot slot = 0; slot < most_things; ++slot) {
    Obstacle& known = obstacles_[static_cast<std::size_t>(slot)];
    const bool stands = things_.has(slot) && blocks_floor(item(slot).object, *item(slot).kind);
    const Version version = stands ? item(slot).version : 0;
    if (known.version == version) continue;
    if (known.version != 0) walkways_.remove(known.footprint);
    if (stands) walkways_.add(item(slot).body.footprint);
    known.version = version;
    if (stands) known.footprint = item(slot).body.footprint;
  }
  walkways_.flood();
}

bool World::reaches_free_zone(Slot slot) const {
  const Zones& zones = zones_[static_cast<std::size_t>(slot)];
  for (std::size_t zone = 0; zone < zones.areas.size(); ++zone)
    if (walkways_.reaches(zones.areas[zone]) && is_zone_free(slot, zone)) return true;
  return zones.areas.empty();
}

bool World::is_reachable() {
  map_walkways();
  if (!walkways_.doors_connected()) return false;
  bool reachable = true;
  things_.each([&](Slot slot) {
    if (reachable) find_zones(slot), reachable = reaches_free_zone(slot);
  });
  return reachable;
}

}  // namespace roomgen::lab::annealing
