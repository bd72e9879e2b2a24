#include <algorithm>
#include <optional>

#include "draft_changes.h"
#include "placing.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr std::size_t most_neighbours = 9, most_at_once = 3;
constexpr int most_trials = 90;
constexpr double least_way = 5e-4;         // metres, less than a file tells apart
constexpr double shrink_steps[] = {0.9, 0.8, 0.7, 0.6};

using Neighbours = std::vector<Cluster>;

// A repair takes whole groups.
bool goes_with_another(const Scene& scene, const Object& object) {
  return !object.group.empty() && object.on.empty() && !is_anchor(scene, object);
}

// What may make way, the nearest first: what stands on the floor, or on the same carrier.
Neighbours neighbours_of(const Draft& draft, const Layout& layout, const Cluster& cluster, const Aim& aim) {
  const Vec2 middle = middle_of(draft, layout, aim);
  const auto own = cluster.ids();
  std::vector<std::pair<double, const Object*>> near;
  for (const auto& object : draft.scene.objects) {
    const bool same_level = cluster.root.mount == Mount::surface ? object.on == cluster.root.on
                                                                 : object.mount == Mount::floor;
    if (object.room != cluster.root.room || object.locked || object.traits.flat || !same_level ||
        own.count(object.id) || draft.named.count(object.id) || goes_with_another(draft.scene, object))
      continue;
    near.emplace_back(gap(footprint(object), middle), &object);
  }
  std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Neighbours neighbours;
  for (std::size_t i = 0; i < std::min(near.size(), most_neighbours); ++i)
    neighbours.push_back(whole_of(draft.scene, *near[i].second));
  return neighbours;
}

/// A way that was made: who stands where now.
struct Way {
  std::vector<Cluster> placed;  ///< the newcomer first
  double metres = 0.0;
};

class WayMaker {
 public:
  WayMaker(Draft& draft, const Cluster& cluster, const Aim& aim, std::vector<RequirementVerdict> held)
      : draft_(draft), cluster_(cluster), aim_(aim), held_(std::move(held)),
        neighbours_(neighbours_of(draft, draft.layout_without(cluster), cluster, aim)) {}

  std::optional<Way> run() {
    for (std::size_t size = 1; size <= std::min(most_at_once, neighbours_.size()); ++size) {
      std::vector<std::size_t> chosen;
      try_sets(size, 0, chosen);
      if (best_) return best_;
    }
    return std::nullopt;
  }
  const std::vector<std::string>& blocking() const { return blocking_; }

 private:
  void try_sets(std::size_t size, std::size_t first, std::vector<std::size_t>& chosen) {
    if (chosen.size() == size) return try_set(chosen);
    for (std::size_t i = first; i < neighbours_.size() && trials_ < most_trials; ++i) {
      chosen.push_back(i);
      try_sets(size, i + 1, chosen);
      chosen.pop_back();
    }
  }

  void try_set(const std::vector<std::size_t>& chosen) {
    ++trials_;
    std::set<std::string> away = cluster_.ids();
    std::vector<const Cluster*> moving;
    for (std::size_t i : chosen) {
      moving.push_back(&neighbours_[i]);
      away.merge(neighbours_[i].ids());
    }
    Layout& layout = draft_.shop.layout(draft_.scene, cluster_.root.room, away);
    auto found = find_place(draft_, layout, cluster_, aim_, Effort::brief);
    if (!found) return;
    if (blocking_.empty())
      for (const auto* one : moving) blocking_.push_back(one->root.id);
    Way way;
    take_place(layout, *std::move(found), way);
    std::stable_sort(moving.begin(), moving.end(), [](const Cluster* a, const Cluster* b) {
      return footprint(a->root).area() > footprint(b->root).area();
    });
    for (const auto* one : moving)
      if (!move_aside(layout, *one, way)) return;
    if ((!best_ || way.metres < best_->metres) && keeps_requirements(way)) best_ = std::move(way);
  }

  static void take_place(Layout& layout, Cluster cluster, Way& way) {
    layout.add(cluster.root);
    for (const auto& object : cluster.carried) layout.add(object);
    way.placed.push_back(std::move(cluster));
  }

  // Its relations hold as before.
  bool move_aside(Layout& layout, const Cluster& neighbour, Way& way) {
    Aim aim;
    aim.asked = held_relations(neighbour.root, neighbour.root.relations, draft_.scene, draft_.shop.kinds());
    aim.near_to = pose_of(neighbour.root);
    aim.most_off = furthest_way;
    aim.turns_freely = true;
    auto found = find_place(draft_, layout, neighbour, aim, Effort::brief);
    if (!found) return false;
    found->root.relations = neighbour.root.relations;
    way.metres += (found->root.position - neighbour.root.position).head<2>().norm();
    take_place(layout, *std::move(found), way);
    return true;
  }

  bool keeps_requirements(const Way& way) {
    Draft trial = draft_;
    for (const auto& cluster : way.placed) trial.put(cluster);
    // What made way may be what it was to stand to.
    const Object& placed = way.placed.front().root;
    return lost_relations(placed, aim_.asked, trial.scene, trial.shop.kinds()).empty() &&
           broken_requirements(held_, trial).empty();
  }

  Draft& draft_;
  const Cluster& cluster_;
  const Aim& aim_;
  const std::vector<RequirementVerdict> held_;
  const Neighbours neighbours_;
  std::optional<Way> best_;
  std::vector<std::string> blocking_;  ///< the first, and so smallest, set without which there is a place
  int trials_ = 0;
};

void take(Draft& draft, const Way& way) {
  for (std::size_t i = 1; i < way.placed.size(); ++i) {
    const Object& now = way.placed[i].root;
    const Object& before = *find_object(draft.scene, now.id);
    roomgen::Move move{now.id, before.position, now.position, wrap_angle(now.yaw - before.yaw)};
    if (move.distance() > least_way || move.turn != 0.0) draft.repairs.push_back(std::move(move));
  }
  for (const auto& cluster : way.placed) draft.put(cluster);
}

// The largest smaller width that finds a place; 0 if none does.
double width_that_fits(Draft& draft, const Cluster& cluster, const Aim& aim) {
  for (const double factor : shrink_steps) {
    Cluster smaller = cluster;
    smaller.root.size.head<2>() *= factor;
    if (find_place(draft, draft.layout_without(cluster), smaller, aim, Effort::brief)) return smaller.root.size.x();
  }
  return 0.0;
}

Error no_way(Draft& draft, const Cluster& cluster, const Aim& aim, const std::string& why,
             const std::vector<std::string>& blocking) {
  std::vector<std::string> help;
  if (!blocking.empty()) help.push_back("removing " + join(blocking, " and "));
  const bool is_new = !find_object(draft.scene, cluster.root.id);
  if (const double width = is_new ? width_that_fits(draft, cluster, aim) : 0.0; width > 0.0)
    help.push_back("a " + cluster.root.category + " of " + format_number(width, 1) + " m");
  return cannot(why + (help.empty() ? "" : "; " + join(help, ", or ") + " would make it fit"));
}

}  // namespace

Status place_or_make_way(Draft& draft, const Cluster& cluster, const Aim& aim) {
  auto found = find_place(draft, draft.layout_without(cluster), cluster, aim);
  if (found) return draft.put(*found), Status();
  WayMaker maker(draft, cluster, aim, ledger_of(draft));
  const auto way = maker.run();
  if (!way || !draft.repair) return no_way(draft, cluster, aim, found.error().message, maker.blocking());
  take(draft, *way);
  return {};
}

}  // namespace roomgen
