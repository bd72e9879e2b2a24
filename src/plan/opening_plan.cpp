#include "opening_plan.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "roomgen/base/text.h"
#include "scene/wall_sides.h"

namespace roomgen::plan {

namespace {

constexpr int in_its_place = 10;  // conflicts, and what one opening more costs a wall
constexpr double across = 4.0;    // for a window: the wall towards which the door looks

/// A stretch with the needs that have been assigned to it.
struct OpeningSite {
  WallStretch stretch;
  std::vector<std::size_t> needs;
};

class OpeningPlanner {
 public:
  OpeningPlanner(const Room& room, const OpeningPlaces& places, std::vector<OpeningNeed> needs,
                 Random random, std::vector<std::string>& notes)
      : room_(room),
        beyond_(places.beyond),
        needs_(std::move(needs)),
        placed_(needs_.size()),
        random_(random),
        notes_(notes) {
    for (const auto& stretch : places.stretches) sites_.push_back({stretch, {}});
  }

  std::vector<Opening> run() {
    for (const std::size_t i : by_rank()) assign(i);
    for (auto& site : sites_)
      if (site.needs.size() == 1)
        place_single(site);
      else if (site.needs.size() > 1)
        place_several(site);
    std::vector<Opening> result;
    for (auto& opening : placed_)
      if (opening) result.push_back(*std::move(opening));
    std::stable_partition(result.begin(), result.end(),
                          [](const Opening& opening) { return opening.is_entrance(); });
    return result;
  }

 private:
  // --- Which stretch ----------------------------------------------------------------------------

  // What is told its wall first, then what nobody asked for but is usual there, then what goes where it likes,
  // then what depends on the others; of equals the entrances, which a room cannot do without.
  std::vector<std::size_t> by_rank() const {
    const auto rank = [&](std::size_t i) {
      const OpeningNeed& need = needs_[i];
      const int group = !need.walls.empty()            ? (need.asked ? 0 : 1)
                        : need.opposite || need.beside ? 3
                                                       : 2;
      return 2 * group + (need.is_window() ? 1 : 0);
    };
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < needs_.size(); ++i) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
    return order;
  }

  void assign(std::size_t index) {
    const OpeningNeed& need = needs_[index];
    const auto told = told_sites(need), all = preferred_sites(need);
    std::optional<std::size_t> site = first_that_takes(told, need, false);
    // What nobody asked for rather moves than become narrower for the others.
    if (!site && !need.asked) site = first_that_takes(all, need, false);
    if (!site) site = first_that_takes(told, need, true);
    if (!site) {
      site = first_that_takes(all, need, false);
      if (!site) site = first_that_takes(all, need, true);
      if (site && !told.empty())
        note(need, "there is no room for it in its wall, it is in another");
    }
    if (site)
      sites_[*site].needs.push_back(index);
    else
      note(need, "it fits into no wall and was left out");
  }

  std::optional<std::size_t> first_that_takes(const std::vector<std::size_t>& sites,
                                              const OpeningNeed& need, bool narrower) const {
    for (const std::size_t site : sites)
      if (takes(sites_[site], need, narrower)) return site;
    return std::nullopt;
  }

  // Is there room for one more, if all may become narrower?
  bool takes(const OpeningSite& site, const OpeningNeed& need, bool narrower) const {
    const double length = site.stretch.length() + 1e-9;
    if (site.needs.empty())
      return (narrower || need.yields ? need.least : need.opening.width()) + 2.0 * need.clear <=
                 length &&
             !(is_extra(need) && has_window(site.stretch.wall));
    if (is_extra(need)) return false;
    const auto width = [&](const OpeningNeed& one) {
      return narrower ? one.least : one.opening.width();
    };
    double sum = width(need) + least_gap * (static_cast<double>(site.needs.size()) + 2.0);
    for (const std::size_t i : site.needs) sum += width(needs_[i]);
    return sum <= length;
  }

  // A window that nobody asked for has a wall without others.
  static bool is_extra(const OpeningNeed& need) { return need.is_window() && !need.asked; }

  bool has_window(std::size_t wall) const { return count_in(wall, true) > 0; }

  int count_in(std::size_t wall, bool windows_only) const {
    int count = 0;
    for (const auto& opening : room_.openings)
      count += opening.wall == wall && !(windows_only && opening.is_entrance());
    for (const auto& site : sites_)
      for (const std::size_t i : site.needs)
        count += site.stretch.wall == wall && (needs_[i].is_window() || !windows_only);
    return count;
  }

  std::vector<std::size_t> sites_in(const std::vector<std::size_t>& walls) const {
    std::vector<std::size_t> found;
    for (const std::size_t wall : walls)
      for (std::size_t s = 0; s < sites_.size(); ++s)
        if (sites_[s].stretch.wall == wall) found.push_back(s);
    return found;
  }

  std::vector<std::size_t> told_sites(const OpeningNeed& need) const {
    if (!need.walls.empty()) return sites_in(need.walls);
    if (const auto wall = need.beside ? wall_of(*need.beside) : std::nullopt)
      return sites_in({*wall});
    if (const auto wall = need.opposite ? wall_of(*need.opposite) : std::nullopt)
      return sites_in(walls_towards(room_.polygon, room_.polygon.inward(*wall)));
    return {};
  }

  // Of the first window, or of the first entrance.
  std::optional<std::size_t> wall_of(OpeningType type) const {
    const bool window = type == OpeningType::window;
    for (const auto& opening : room_.openings)
      if (opening.is_entrance() != window) return opening.wall;
    for (std::size_t i = 0; i < needs_.size(); ++i)
      if (needs_[i].is_window() == window)
        for (const auto& site : sites_)
          if (std::count(site.needs.begin(), site.needs.end(), i) > 0) return site.stretch.wall;
    return std::nullopt;
  }

  std::vector<std::size_t> preferred_sites(const OpeningNeed& need) const {
    const auto door = wall_of(OpeningType::door);
    std::vector<std::pair<double, std::size_t>> costs;
    for (std::size_t s = 0; s < sites_.size(); ++s) {
      const WallStretch& stretch = sites_[s].stretch;
      double cost = in_its_place * count_in(stretch.wall, false) - need.likes_length * stretch.length();
      if (need.is_window() && door)
        cost += across * room_.polygon.inward(stretch.wall).dot(room_.polygon.inward(*door));
      if (sites_[s].needs.empty())
        cost += in_its_place * conflicts_of(placed_alone(room_, need, stretch, beyond_));
      costs.emplace_back(cost, s);
    }
    std::stable_sort(costs.begin(), costs.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first - 1e-9; });
    std::vector<std::size_t> order;
    for (const auto& [cost, site] : costs) order.push_back(site);
    return order;
  }

  int conflicts_of(const Opening& opening) const {
    return conflicts(room_, opening) + (beyond_ ? beyond_(opening) : 0);
  }

  void note(const OpeningNeed& need, const std::string& what) {
    if (!need.asked) return;
    const std::string kind =
        need.opening.kind.empty() ? std::string(name(need.opening.type)) : need.opening.kind;
    const std::string text = kind + ": " + what;
    if (std::find(notes_.begin(), notes_.end(), text) == notes_.end()) notes_.push_back(text);
  }

  void note_width(const OpeningNeed& need, double width, const WallStretch& stretch) {
    if (width < need.opening.width() - 0.01)
      note(need, "made narrower, since its wall is " + format_number(stretch.length(), 2) + " m long");
  }

  // --- Where in its stretch ---------------------------------------------------------------------

  void place_single(const OpeningSite& site) {
    const std::size_t index = site.needs.front();
    OpeningNeed& need = needs_[index];
    if (need.middles.empty() && need.likes_corner()) {
      const double end = random_.chance(0.5) ? 0.0 : 1.0;
      need.middles = {end, 1.0 - end, 0.5};
    }
    const Opening opening = placed_alone(room_, need, site.stretch, beyond_);
    note_width(need, opening.width(), site.stretch);
    put(index, opening);
  }

  void put(std::size_t index, const Opening& opening) {
    placed_[index] = opening;
    room_.openings.push_back(opening);
  }

  void place_several(const OpeningSite& site) {
    shrink_to_fit(site);
    spread_along(site.stretch, order_along(site));
  }

  void shrink_to_fit(const OpeningSite& site) {
    const double free =
        site.stretch.length() - least_gap * (static_cast<double>(site.needs.size()) + 1.0);
    double sum = 0.0, least = 0.0;
    for (const std::size_t i : site.needs) {
      sum += needs_[i].opening.width();
      least += needs_[i].least;
    }
    if (sum <= free + 1e-9) return;
    const double part = sum > least ? std::clamp((free - least) / (sum - least), 0.0, 1.0) : 0.0;
    for (const std::size_t i : site.needs) {
      OpeningNeed& need = needs_[i];
      const double width = need.least + part * (need.opening.width() - need.least);
      note_width(need, width, site.stretch);
      need.opening.to = need.opening.from + width;
    }
  }

  // Doors that like corners at the ends, the others between them.
  std::vector<std::size_t> order_along(const OpeningSite& site) {
    std::vector<std::size_t> corner, middle;
    for (const std::size_t i : site.needs)
      (needs_[i].likes_corner() ? corner : middle).push_back(i);
    const bool from_start = random_.chance(0.5);
    std::vector<std::size_t> order;
    if (!corner.empty() && (from_start || corner.size() > 1)) {
      order.push_back(corner.front());
      corner.erase(corner.begin());
    }
    // A wide door between windows, not beside them.
    std::stable_partition(middle.begin(), middle.end(),
                          [&](std::size_t i) { return needs_[i].is_window(); });
    const auto first_door = std::find_if(middle.begin(), middle.end(),
                                         [&](std::size_t i) { return !needs_[i].is_window(); });
    std::rotate(middle.begin() + (first_door - middle.begin()) / 2, first_door, middle.end());
    order.insert(order.end(), middle.begin(), middle.end());
    order.insert(order.end(), corner.begin(), corner.end());
    return order;
  }

  double width_of(std::span<const std::size_t> order) const {
    double sum = 0.0;
    for (const std::size_t i : order) sum += needs_[i].opening.width();
    return sum;
  }

  void spread_along(WallStretch left, std::span<const std::size_t> order) {
    const double spare = left.length() - width_of(order);
    const double offset = std::min(corner_offset, spare / (static_cast<double>(order.size()) + 1.0));
    const auto at_end = [&](std::size_t i, double end) {
      put(i, moved_to(needs_[i].opening, left, end, offset));
    };
    if (!order.empty() && needs_[order.front()].likes_corner()) {
      at_end(order.front(), 0.0);
      left.from = placed_[order.front()]->to;
      order = order.subspan(1);
    }
    if (!order.empty() && needs_[order.back()].likes_corner()) {
      at_end(order.back(), 1.0);
      left.to = placed_[order.back()]->from;
      order = order.first(order.size() - 1);
    }
    const double gap =
        (left.length() - width_of(order)) / (static_cast<double>(order.size()) + 1.0);
    for (const std::size_t i : order) {
      const double width = needs_[i].opening.width();
      put(i, moved_to(needs_[i].opening, {left.wall, left.from + gap, left.from + gap + width}, 0.5, 0.0));
      left.from += gap + width;
    }
  }

  Room room_;  ///< with what has been placed
  ConflictsBeyond beyond_;
  std::vector<OpeningNeed> needs_;
  std::vector<std::optional<Opening>> placed_;  ///< by need
  Random random_;
  std::vector<std::string>& notes_;
  std::vector<OpeningSite> sites_;
};

// An end of its wall beside a door is a corner of the room, or the wall goes round it.
bool is_at_edge(const Room& room, const Opening& door) {
  const double length = room.polygon.edge(door.wall).length();
  const std::size_t next = (door.wall + 1) % room.polygon.size();
  return (door.from <= corner_offset + 1e-9 && !room.polygon.is_convex_corner(door.wall)) ||
         (door.to >= length - corner_offset - 1e-9 && !room.polygon.is_convex_corner(next));
}

}  // namespace

int conflicts(const Room& room, const Opening& opening) {
  int found = 0;
  for (const auto& other : room.openings) {
    if (other.wall == opening.wall && opening.from < other.to + between_openings &&
        other.from < opening.to + between_openings)
      found += in_its_place;
    else if (opening.is_entrance() && other.is_entrance() &&
             overlaps(door_clearance(room, opening), door_clearance(room, other)))
      ++found;
  }
  if (!opening.is_entrance()) return found;
  if (!contains(room.polygon, door_clearance(room, opening))) found += 2;
  return found + (is_at_edge(room, opening) ? 1 : 0);
}

Opening placed_alone(const Room& room, const OpeningNeed& need, const WallStretch& stretch,
                     const ConflictsBeyond& beyond) {
  Opening opening = need.opening;
  const double most = stretch.length() - 2.0 * need.clear;
  opening.to = opening.from + std::min(opening.width(), std::max(need.least, most));
  const double offset = need.opening.is_entrance() ? corner_offset : need.clear;
  std::vector<double> middles = need.middles;
  if (middles.empty()) middles = need.likes_corner() ? std::vector{0.0, 1.0, 0.5} : std::vector{0.5};
  std::optional<Opening> best;
  int fewest = 0;
  for (const double middle : middles) {
    const Opening there = moved_to(opening, stretch, middle, offset);
    const int found = conflicts(room, there) + (beyond ? beyond(there) : 0);
    if (!best || found < fewest) best = there, fewest = found;
  }
  return *best;
}

std::vector<Opening> place_openings(const Room& room, const OpeningPlaces& places,
                                    std::vector<OpeningNeed> needs, Random random,
                                    std::vector<std::string>& notes) {
  return OpeningPlanner(room, places, std::move(needs), random, notes).run();
}

std::string free_opening_id(const Room& room, OpeningType type) {
  const std::string stem = type == OpeningType::window ? "window-" : "door-";
  for (int n = 0;; ++n)
    if (const std::string id = stem + std::to_string(n); !find_opening(room, id)) return id;
}

void name_openings(Room& room) {
  for (auto& opening : room.openings)
    if (opening.id.empty()) opening.id = free_opening_id(room, opening.type);
}

}  // namespace roomgen::plan
