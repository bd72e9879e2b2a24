#include "learned_unit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace roomgen::book {

namespace {

constexpr double hand = 0.12;          ///< metres between what belongs together without a word
constexpr double at_table = 0.6;       ///< from a seat to its table, at most
constexpr double beyond_gap = 0.35;    ///< above the usual gap of two kinds
constexpr double at_its_wall = 0.15;   ///< from the back of a thing to the wall that it stands at
constexpr double much_smaller = 0.4;   ///< of the floor of what a thing merely touches
constexpr double most_of_table = 1.5;  ///< of its floor: a sofa does not follow its coffee table
constexpr double least_on_rug = 0.15;  ///< of a rug, below what it belongs to

double floor_of(const Object& object) {
  return object.size.x() * object.size.y();
}

/// Says of each thing to which other one it belongs.
class Gathering {
 public:
  Gathering(const Scene& scene, const KindTable& kinds)
      : objects_(scene.objects), kinds_(kinds), leader_(objects_.size()) {
    std::iota(leader_.begin(), leader_.end(), std::size_t{0});
  }

  std::vector<Unit> run() {
    follow_carriers();
    follow_groups();
    follow_the_served();
    std::map<std::size_t, Unit> units;
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      Unit& unit = units[root(i)];
      unit.things.insert(root(i) == i ? unit.things.begin() : unit.things.end(), &objects_[i]);
    }
    std::vector<Unit> found;
    for (auto& [leader, unit] : units) {
      unit.id = objects_[leader].group.empty() ? objects_[leader].id : objects_[leader].group;
      unit.at = objects_[leader].position.head<2>();
      unit.box = floor_box(unit.things);
      found.push_back(std::move(unit));
    }
    return found;
  }

 private:
  std::size_t root(std::size_t i) const {
    while (leader_[i] != i) i = leader_[i];
    return i;
  }
  const Kind& kind(const Object& object) const { return kinds_.get(object.category); }
  bool is_furniture(const Object& object) const {
    return object.mount == Mount::floor && !object.traits.flat;
  }
  // Copies are as the first of them: what is beside one of them is not theirs.
  bool is_copy(std::size_t i) const {
    return objects_[root(i)].group.find('#') != std::string::npos;
  }

  void follow(std::size_t i, std::size_t leader) {
    if (root(leader) != i) leader_[i] = leader;
  }

  void follow_carriers() {
    for (std::size_t i = 0; i < objects_.size(); ++i)
      for (std::size_t j = 0; j < objects_.size() && objects_[i].mount == Mount::surface; ++j)
        if (objects_[j].id == objects_[i].on) follow(i, j);
  }

  void follow_groups() {
    std::map<std::string, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < objects_.size(); ++i)
      if (!objects_[i].group.empty() && leader_[i] == i) groups[objects_[i].group].push_back(i);
    for (const auto& [id, members] : groups) {
      auto first = std::find_if(members.begin(), members.end(),
                                [&](std::size_t i) { return is_furniture(objects_[i]); });
      if (first == members.end()) first = members.begin();
      for (const std::size_t i : members) follow(i, *first);
    }
  }

  // Small things first: who serves a table that serves a sofa is with the sofa, too.
  void follow_the_served() {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < objects_.size(); ++i)
      if (leader_[i] == i && objects_[i].group.empty()) order.push_back(i);
    const auto rank = [&](std::size_t i) { return is_furniture(objects_[i]) ? 0 : 1; };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::pair(rank(a), floor_of(objects_[a])) < std::pair(rank(b), floor_of(objects_[b]));
    });
    for (const std::size_t i : order) {
      std::size_t best = i;
      double most = 0.0;
      for (std::size_t j = 0; j < objects_.size(); ++j) {
        if (j == i || !is_furniture(objects_[j]) || root(j) == i || is_copy(j)) continue;
        const double service = service_of(objects_[i], objects_[j]);
        if (service > most) most = service, best = j;
      }
      follow(i, best);
    }
  }

  // 0: it does not serve the other; more is nearer to it.
  double service_of(const Object& thing, const Object& other) const {
    if (thing.mount == Mount::wall) return is_above(thing, other) ? 1.0 : 0.0;
    const Footprint own = footprint(thing), its = footprint(other);
    if (thing.mount == Mount::ceiling) {
      const bool is_over = top(other) < bottom(thing) && contains(its, Vec2(own.center()));
      return is_over ? 1.0 + floor_of(other) : 0.0;
    }
    return thing.traits.flat ? on_rug(own, its) : service_beside(thing, other);
  }

  double service_beside(const Object& thing, const Object& other) const {
    const Footprint own = footprint(thing), its = footprint(other);
    const double between = gap(own, its);
    const double nearness = 1.0 / (1.0 + between);
    if (sits_at(thing, other) && between <= at_table && looks_at(own, its)) return 4.0 + nearness;
    const bool is_smaller = floor_of(thing) < floor_of(other);
    // A coffee table is the sofa's rather than an armchair's that is a little nearer.
    const double greatness = 0.2 * std::min(2.0, floor_of(other));
    if (is_smaller && between <= usual_gap(thing, other)) return 3.0 + nearness + greatness;
    if (is_smaller && stands_in_zone(thing, other)) return 2.0 + nearness;
    return between <= hand && is_part_of(thing, other) ? nearness : 0.0;
  }
  bool is_part_of(const Object& thing, const Object& other) const {
    return floor_of(thing) < much_smaller * floor_of(other) ||
           (thing.category == other.category && !kinds_.is_a(thing.category, "seat"));
  }

  bool covers_window(const Object& thing) const { return kind(thing).covers_window; }

  // It hangs over the other, at the wall behind that.
  bool is_above(const Object& thing, const Object& other) const {
    if (covers_window(thing)) return false;
    const Vec2 local = footprint(other).to_local(thing.position.head<2>());
    const double off = 0.5 * (other.size.y() + thing.size.y());
    return std::abs(std::sin(0.5 * (thing.yaw - other.yaw))) < 0.05 &&
           bottom(thing) > top(other) - 0.05 && std::abs(local.x()) <= 0.5 * other.size.x() + 0.1 &&
           local.y() > 0.0 && local.y() - 0.5 * other.size.y() < at_its_wall &&
           local.y() < off + at_its_wall;
  }

  static double on_rug(const Footprint& rug, const Footprint& other) {
    constexpr int steps = 8;
    int inside = 0;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j) {
        const Vec2 part((i + 0.5) / steps - 0.5, (j + 0.5) / steps - 0.5);
        if (contains(other, rug.to_world(2.0 * part.cwiseProduct(rug.half())))) ++inside;
      }
    const double share = inside / static_cast<double>(steps * steps);
    return share >= least_on_rug ? share : 0.0;
  }

  bool sits_at(const Object& thing, const Object& other) const {
    return floor_of(thing) < most_of_table * floor_of(other) &&
           kinds_.is_a(thing.category, "seat") &&
           kinds_.is_any_of(other.category, {"table", "kitchen island"});
  }
  static bool looks_at(const Footprint& own, const Footprint& its) {
    return its.round() || contains(its, own.center())
               ? true
               : own.front().dot((its.center() - own.center()).normalized()) > 0.3 ||
                     ray_hit(its, own.center(), own.front()) >= 0.0;
  }

  // Below 0: they have nothing to do with each other.
  double usual_gap(const Object& thing, const Object& other) const {
    double most = -1.0;
    const auto look = [&](const Object& a, const Object& b) {
      for (const auto& one : kind(a).gaps)
        if (kinds_.is_a(b.category, one.partner)) most = std::max(most, one.high + beyond_gap);
    };
    look(thing, other), look(other, thing);
    return most;
  }

  bool stands_in_zone(const Object& thing, const Object& other) const {
    for (const auto& zone : kind(other).zones)
      if (kinds_.is_any_of(thing.category, zone.partners) &&
          contains(zone_footprint(footprint(other), zone), Vec2(thing.position.head<2>())))
        return true;
    return false;
  }

  const std::vector<Object>& objects_;
  const KindTable& kinds_;
  std::vector<std::size_t> leader_;
};

}  // namespace

Bounds2 floor_box(const std::vector<const Object*>& things) {
  for (const bool stands : {true, false}) {
    Bounds2 box;
    for (const Object* thing : things)
      if (!stands || (thing->mount == Mount::floor && !thing->traits.flat))
        for (const Vec2& corner : footprint(*thing).outline()) box.add(corner);
    if (box.low.x() <= box.high.x()) return box;
  }
  return {Vec2::Zero(), Vec2::Zero()};
}

std::vector<Unit> units_of(const Scene& scene, const KindTable& kinds) {
  return in_grids(Gathering(scene, kinds).run());
}

}  // namespace roomgen::book
