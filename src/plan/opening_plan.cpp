#include "opening_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "roomgen/base/text.h"
#include "scene/opening_kind.h"
#include "usual_openings.h"
#include "wall_sides.h"

namespace roomgen::design {

namespace {

constexpr double least_gap = 0.15;      // between openings, and to the corners
constexpr double least_door = 0.6;
constexpr double wide_door = 1.2;    // a wider one goes to the middle of its wall
constexpr double enlarged = 1.5;     // a large window against a usual one

// An opening that looks for its place.
struct Item {
  Opening opening;
  double least = least_window;     ///< width, metres
  std::vector<std::size_t> walls;  ///< told, by preference; empty: any
  std::optional<OpeningType> opposite, beside;
  bool kept = false;  ///< was there before
};

struct Wall {
  std::vector<std::size_t> items;
};

bool is_window(OpeningType type) {
  return type == OpeningType::window;
}

class OpeningPlanner {
 public:
  OpeningPlanner(Room& room, const RoomKind& kind, const OpeningKinds& kinds, Random random,
          std::vector<std::string>& notes)
      : room_(room), kind_(kind), kinds_(kinds), random_(random), notes_(notes) {
    walls_.resize(room.polygon.size());
    // Walls of one length shall not always be taken in the file's order.
    for (std::size_t k = 0; k < walls_.size(); ++k) shuffled_.push_back(k);
    random_.shuffle(shuffled_);
  }

  void run(const std::vector<OpeningWish>& wishes) {
    keep_openings(wishes);
    for (const auto& wish : wishes) add(wish);
    assign();
    lay_out();
  }

 private:
  // --- What there is to be placed ---------------------------------------------------------------

  void keep_openings(const std::vector<OpeningWish>& wishes) {
    const bool entrances = std::none_of(wishes.begin(), wishes.end(), [](const OpeningWish& wish) {
      return !is_window(wish.type);
    });
    for (const auto& opening : room_.openings) {
      if (opening.is_entrance() && !entrances) continue;
      Item item;
      item.opening = opening;
      item.least = std::min(opening.width(), opening.is_entrance() ? least_door : least_window);
      item.walls = {opening.wall};
      item.kept = true;
      items_.push_back(std::move(item));
    }
    room_.openings.clear();
  }

  void add(const OpeningWish& wish) {
    const OpeningKind* kind = kinds_.find(wish.kind);
    if (!kind) return;
    std::vector<int> sides = wish.sides;
    const Opening opening = opening_of(wish, *kind);
    for (int i = 0; i < wish.count; ++i) {
      Item item;
      item.opening = opening;
      item.least = std::min(item.opening.width(), kind->least_width);
      if (!sides.empty())
        item.walls = walls_on_side(room_.polygon, sides[static_cast<std::size_t>(i) % sides.size()]);
      else if (wish.walls > 0)
        item.walls = spread(wish, i);
      item.opposite = wish.opposite;
      item.beside = wish.beside;
      items_.push_back(std::move(item));
    }
  }

  Opening opening_of(const OpeningWish& wish, const OpeningKind& kind) {
    Opening opening;
    opening.type = kind.type;
    opening.kind = kind.name == name(kind.type) ? std::string() : kind.name;
    opening.leaves = kind.leaves;
    opening.glazed = kind.glazed;
    opening.outline = kind.outline;
    opening.swing = kind.swing.value_or(kind_.swing);
    opening.to = width_of(wish, kind);
    set_heights(wish, kind, opening);
    return opening;
  }

  double width_of(const OpeningWish& wish, const OpeningKind& kind) {
    if (wish.width) return *wish.width;
    const double width = kind.width             ? *kind.width
                         : is_window(kind.type) ? usual_window_width(kind_, false, random_)
                                                : kind_.door;
    const bool large_window = is_window(kind.type) && wish.wide > 1.0;
    return std::max(kind.least_width, width * (large_window ? enlarged : wish.wide));
  }

  void set_heights(const OpeningWish& wish, const OpeningKind& kind, Opening& opening) const {
    const double highest = room_.height - under_ceiling;
    const bool window = is_window(kind.type);
    const double usual_head = window ? kind_.windows.head : default_door_head;
    opening.head = kind.to_ceiling ? highest : std::min(kind.head.value_or(usual_head), highest);
    opening.sill = window ? kind.sill.value_or(kind_.windows.sill) : 0.0;
    if (wish.high > 1.0) {
      opening.head = std::min(highest, opening.head * wish.high);
      opening.sill /= wish.high * wish.high;
    }
    if (wish.high < 1.0 && window)
      opening.sill = opening.head - wish.high * (opening.head - opening.sill);
    if (wish.height && window) opening.sill = std::max(0.0, opening.head - *wish.height);
    if (wish.height && !window) opening.head = std::clamp(*wish.height, 1.8, highest);
    opening.sill = std::clamp(opening.sill, 0.0, std::max(0.0, opening.head - least_height));
  }

  // --- Which wall -------------------------------------------------------------------------------

  double length(std::size_t wall) const { return room_.polygon.edge(wall).length(); }

  // "windows on two walls": the i-th on the wall that is its turn.
  std::vector<std::size_t> spread(const OpeningWish& wish, int i) const {
    auto longest = shuffled_;
    std::stable_sort(longest.begin(), longest.end(),
                     [&](std::size_t a, std::size_t b) { return length(a) > length(b) + 1e-9; });
    const std::size_t count = std::min(static_cast<std::size_t>(wish.walls), longest.size());
    return {longest[static_cast<std::size_t>(i) % count]};
  }

  void assign() {
    // Told places first, then what goes where it likes, then what depends on the others; of equals
    // the entrances, which a room cannot do without.
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < items_.size(); ++i) order.push_back(i);
    const auto rank = [&](std::size_t i) {
      const Item& item = items_[i];
      const int group = !item.walls.empty()            ? (item.kept ? 1 : 0)
                        : item.opposite || item.beside ? 3
                                                       : 2;
      return 2 * group + (is_window(item.opening.type) ? 1 : 0);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
    for (const std::size_t i : order) assign(i);
  }

  void assign(std::size_t index) {
    const Item& item = items_[index];
    const auto told = told_walls(item), all = preferred_walls(item);
    std::optional<std::size_t> wall = first_that_takes(told, item, false);
    // What was there before rather moves than shrinks.
    if (!wall && item.kept) wall = first_that_takes(all, item, false);
    if (!wall) wall = first_that_takes(told, item, true);
    if (!wall) {
      wall = first_that_takes(all, item, false);
      if (!wall) wall = first_that_takes(all, item, true);
      if (wall && !told.empty())
        note(item, "there is no room for it in its wall, it is in another");
    }
    if (wall)
      walls_[*wall].items.push_back(index);
    else
      note(item, "it fits into no wall and was left out");
  }

  std::optional<std::size_t> first_that_takes(const std::vector<std::size_t>& walls,
                                              const Item& item, bool shrink) const {
    for (const std::size_t wall : walls)
      if (takes(wall, item, shrink)) return wall;
    return std::nullopt;
  }

  std::vector<std::size_t> told_walls(const Item& item) const {
    if (!item.walls.empty()) return item.walls;
    if (const auto wall = item.beside ? wall_of(*item.beside) : std::nullopt) return {*wall};
    if (const auto wall = item.opposite ? wall_of(*item.opposite) : std::nullopt)
      return walls_towards(room_.polygon, room_.polygon.inward(*wall));
    return {};
  }

  std::optional<std::size_t> wall_of(OpeningType type) const {
    for (std::size_t i = 0; i < items_.size(); ++i)
      if (is_window(items_[i].opening.type) == is_window(type))
        for (std::size_t k = 0; k < walls_.size(); ++k)
          if (std::count(walls_[k].items.begin(), walls_[k].items.end(), i) > 0) return k;
    return std::nullopt;
  }

  // Walls with few openings before others; for windows those across from the door, for all the
  // longer.
  std::vector<std::size_t> preferred_walls(const Item& item) const {
    const auto door = wall_of(OpeningType::door);
    const bool window = is_window(item.opening.type);
    const auto cost = [&](std::size_t k) {
      double total = 10.0 * static_cast<double>(walls_[k].items.size()) - 0.5 * length(k);
      if (window && door) total += 4.0 * room_.polygon.inward(k).dot(room_.polygon.inward(*door));
      return total;
    };
    auto order = shuffled_;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return cost(a) < cost(b) - 1e-9; });
    return order;
  }

  // Is there room for one more, if all may shrink?
  bool takes(std::size_t wall, const Item& item, bool shrink) const {
    const auto need = [&](const Item& one) { return shrink ? one.least : one.opening.width(); };
    double sum = need(item) + least_gap * (static_cast<double>(walls_[wall].items.size()) + 2.0);
    for (const std::size_t i : walls_[wall].items) sum += need(items_[i]);
    return sum <= length(wall) + 1e-9;
  }

  void note(const Item& item, const std::string& what) {
    const std::string kind =
        item.opening.kind.empty() ? std::string(name(item.opening.type)) : item.opening.kind;
    const std::string text = kind + ": " + what;
    if (std::find(notes_.begin(), notes_.end(), text) == notes_.end()) notes_.push_back(text);
  }

  // --- Where in its wall ------------------------------------------------------------------------

  void lay_out() {
    int entrances = 0, windows = 0;
    for (std::size_t k = 0; k < walls_.size(); ++k)
      if (!walls_[k].items.empty()) lay_out(k);
    for (auto& item : items_) {
      if (!placed_.count(&item)) continue;
      item.opening.id = is_window(item.opening.type) ? "window-" + std::to_string(windows++)
                                                     : "door-" + std::to_string(entrances++);
      room_.openings.push_back(item.opening);
    }
    // Entrances first, as everywhere.
    std::stable_partition(room_.openings.begin(), room_.openings.end(),
                          [](const Opening& opening) { return opening.is_entrance(); });
  }

  // A single opening that was there and has its wall to itself stays where it is.
  bool stays(const Wall& wall) const {
    return wall.items.size() == 1 && items_[wall.items[0]].kept;
  }

  static bool wants_corner(const Item& item) {
    return item.opening.is_entrance() && item.opening.width() < wide_door;
  }

  void lay_out(std::size_t k) {
    Wall& wall = walls_[k];
    if (!stays(wall)) {
      shrink_to_fit(k);
      spread_along(k, order_along(wall));
    }
    for (const std::size_t i : wall.items) {
      items_[i].opening.wall = k;
      placed_.insert(&items_[i]);
    }
  }

  void shrink_to_fit(std::size_t k) {
    const Wall& wall = walls_[k];
    const double free = length(k) - least_gap * (static_cast<double>(wall.items.size()) + 1.0);
    double sum = 0.0, least = 0.0;
    for (const std::size_t i : wall.items) {
      sum += items_[i].opening.width();
      least += items_[i].least;
    }
    if (sum <= free + 1e-9) return;
    const double part = sum > least ? std::clamp((free - least) / (sum - least), 0.0, 1.0) : 0.0;
    for (const std::size_t i : wall.items) {
      Item& item = items_[i];
      const double width = item.least + part * (item.opening.width() - item.least);
      if (width < item.opening.width() - 0.01)
        note(item, "made narrower, since its wall is " + format_number(length(k), 2) + " m long");
      item.opening.to = item.opening.from + width;
    }
  }

  // Doors that like corners at the ends of the wall, the others between them.
  std::vector<std::size_t> order_along(const Wall& wall) {
    std::vector<std::size_t> corner, middle;
    for (const std::size_t i : wall.items) (wants_corner(items_[i]) ? corner : middle).push_back(i);
    const bool from_start = random_.chance(0.5);
    std::vector<std::size_t> order;
    if (!corner.empty() && (from_start || corner.size() > 1)) {
      order.push_back(corner.front());
      corner.erase(corner.begin());
    }
    // A wide door between windows, not beside them.
    std::stable_partition(middle.begin(), middle.end(),
                          [&](std::size_t i) { return !items_[i].opening.is_entrance(); });
    const auto first_door = std::find_if(middle.begin(), middle.end(), [&](std::size_t i) {
      return items_[i].opening.is_entrance();
    });
    std::rotate(middle.begin() + (first_door - middle.begin()) / 2, first_door, middle.end());
    order.insert(order.end(), middle.begin(), middle.end());
    order.insert(order.end(), corner.begin(), corner.end());
    return order;
  }

  void spread_along(std::size_t k, const std::vector<std::size_t>& order) {
    double low = 0.0, high = length(k), sum = 0.0;
    std::size_t first = 0, last = order.size();
    const auto put = [&](std::size_t i, double from, bool hinge_at_from) {
      Opening& opening = items_[i].opening;
      const double width = opening.width();
      opening.from = from;
      opening.to = from + width;
      opening.hinge_at_from = hinge_at_from;
    };
    double total = 0.0;
    for (const std::size_t i : order) total += items_[i].opening.width();
    const double spare = high - total;
    const double offset =
        std::min(corner_offset, spare / (static_cast<double>(order.size()) + 1.0));
    if (first < last && wants_corner(items_[order[first]])) {
      put(order[first], offset, true);
      low = items_[order[first]].opening.to;
      ++first;
    }
    if (first < last && wants_corner(items_[order[last - 1]])) {
      const double width = items_[order[last - 1]].opening.width();
      put(order[last - 1], high - offset - width, false);
      high -= offset + width;
      --last;
    }
    for (std::size_t n = first; n < last; ++n) sum += items_[order[n]].opening.width();
    const double gap = (high - low - sum) / (static_cast<double>(last - first) + 1.0);
    double at = low + gap;
    for (std::size_t n = first; n < last; ++n) {
      const double width = items_[order[n]].opening.width();
      put(order[n], at, true);
      at += width + gap;
    }
  }

  Room& room_;
  const RoomKind& kind_;
  const OpeningKinds& kinds_;
  Random random_;
  std::vector<std::string>& notes_;
  std::vector<Item> items_;
  std::vector<Wall> walls_;
  std::vector<std::size_t> shuffled_;
  std::set<const Item*> placed_;
};

}  // namespace

void plan_openings(Room& room, const RoomKind& kind, const std::vector<OpeningWish>& wishes,
                   Random random, std::vector<std::string>& notes) {
  const auto& kinds = OpeningKinds::built_in();
  if (!kinds) return;
  std::vector<OpeningWish> windows = wishes;
  std::erase_if(windows, [](const OpeningWish& wish) { return !is_window(wish.type); });
  // A room that nobody enters keeps the door that it had.
  const std::array<const std::vector<OpeningWish>*, 2> attempts = {&wishes, &windows};
  for (const auto* wanted : attempts) {
    if (wanted->empty()) return;
    Room planned = room;
    OpeningPlanner(planned, kind, *kinds, random, notes).run(*wanted);
    const bool has_entrance =
        std::any_of(planned.openings.begin(), planned.openings.end(),
                    [](const Opening& opening) { return opening.is_entrance(); });
    if (!check(planned) || !has_entrance) continue;
    room = std::move(planned);
    return;
  }
}

}  // namespace roomgen::design
