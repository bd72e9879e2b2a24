#include "meet.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "complexity.h"
#include "solve/arrangement.h"

namespace roomgen::lab::compose {

namespace {

constexpr const char* any_seat = "seat";  // the kind of which all seats are
constexpr double headroom = 2.0;        // beyond the least, where nobody said how many at most
constexpr std::size_t most_fillers = 8; // kinds; each is loaded
constexpr double most_of_one = 12.0;    // things of a kind that fills the room up
constexpr double most_of_own = 4.0;     // of one that just such rooms hold: a dozen ladders are nobody's workshop
constexpr double crowded = 0.3;         // share of the floor beyond which walls alone do not do
constexpr double packed = 0.48, larger = 1.2;  // share from which things are chosen larger than usual, by this factor
// A room may hardly be fuller (docs/benchmarks.md), nor does anybody want it emptier.
constexpr double fullest = 0.55, emptiest = 0.04;
// So full a room of any size still has the floor that use and ways need.
constexpr double fullest_chosen = 0.42;

double most_of(const Range& range) { return std::isinf(range.high) ? range.low + headroom : range.high; }

class Opener {
 public:
  Opener(const Complexity& asked, const Means& means, std::vector<Stand>& stands, std::vector<std::string>& notes)
      : asked_(asked),
        room_(means.room),
        excluded_(means.excluded),
        kinds_(means.kinds),
        stands_(stands),
        notes_(notes) {}

  void open_numbers() {
    // "Seats for ten" are seats of any kind.
    if (asked_.seats) std::erase_if(stands_, [](const Stand& stand) { return stand.kind == any_seat; });
    // What nobody asked for spoils no number that somebody gave.
    std::erase_if(stands_, [&](const Stand& stand) { return !stand.asked && counts_as_asked(stand.kind); });
    const auto& vocabulary = ProgramVocabulary::built_in();
    if (asked_.seats)
      open("seats", *asked_.seats,
           [&](const Stand& stand) { return seats_on(vocabulary, kinds_.get(stand.kind), stand.size.x()); });
    if (asked_.shelves)
      open("shelves", *asked_.shelves, [&](const Stand& stand) { return is_shelf(stand.kind) ? 1.0 : 0.0; });
    if (asked_.objects) fill_with_things(*asked_.objects);
    keep_essentials();
  }

  void fill_floor(const Range& wanted, double area) {
    const double middle = std::min(fullest, middle_share(wanted));
    const double missing = middle * area - most_footprint(stands_, kinds_);
    if (missing <= 0.0) return;
    auto names = fillers(true);
    if (middle > crowded)
      std::ranges::stable_sort(names, std::greater(), [&](const auto& name) { return filling(name); });
    for (std::size_t i = 0; i < std::min(names.size(), most_fillers); ++i) {
      const Vec3& size = kinds_.get(names[i]).size;
      const auto& anywhere = complexity_words().made_up_with.at("floor");
      const double most = std::ranges::find(anywhere, names[i]) == anywhere.end() ? most_of_own : most_of_one;
      add(names[i], std::clamp(std::ceil(missing / (size.x() * size.y())), 1.0, most));
    }
    if (middle <= crowded) return;
    for (auto& stand : stands_) stand.at_wall = stand.at_wall && stand.asked;
  }

  // People need as much floor beside large things as beside small ones, so large ones fill a floor better.
  void enlarge(const Range& wanted) {
    if (middle_share(wanted) < packed) return;
    for (auto& stand : stands_)
      if (footprint_of(stand, kinds_) > 0.0 && !is_seat(stand.kind)) stand.size.head<2>() *= larger;
  }

 private:
  bool is_shelf(const std::string& kind) const {
    return has_tag(ProgramVocabulary::built_in(), kinds_.get(kind), "shelf");
  }
  bool is_seat(const std::string& kind) const {
    return seats_on(ProgramVocabulary::built_in(), kinds_.get(kind), 1.0) > 0.0;
  }

  // Makes things of one sort come in such numbers that their worth (seats each) may be what is asked for.
  template <typename Worth>
  void open(const char* measure, const Range& wanted, Worth worth) {
    double fixed = 0.0;
    for (const auto& stand : stands_)
      if (stand.asked) fixed += worth(stand) * stand.count.low;
    // "A low number of shelves" are not two.
    for (auto& stand : stands_)
      if (const double each = worth(stand); stand.may_grow && each > 0.0 && fixed > wanted.high) {
        const double fewer = std::min(stand.count.low, std::ceil((fixed - wanted.high) / each));
        stand.count.low -= fewer, fixed -= each * fewer;
      }
    tell_if_too_many(measure, fixed, wanted);
    const double least = std::max(0.0, wanted.low - fixed), most = std::max(0.0, most_of(wanted) - fixed);
    const auto is_free = [&](const Stand& stand) { return worth(stand) > 0.0 && (!stand.asked || stand.may_grow); };
    const auto& usual = complexity_words().made_up_with.at(measure);
    if (least > 0.0 && std::ranges::none_of(stands_, is_free)) add_one_of(usual, most);
    // Chairs for the tables that are asked for, where the room's own seats do not go to tables.
    const auto gathers = [&](const Stand& stand) { return gathers_at_asked(stand.kind); };
    if (const auto gathering = std::ranges::find_if(usual, [&](const auto& kind) { return gathers_at_asked(kind); });
        least > 0.0 && gathering != usual.end() &&
        std::ranges::none_of(stands_, [&](const Stand& stand) { return is_free(stand) && gathers(stand); }))
      add_one_of({*gathering}, most);
    const double given = give_essentials(is_free, worth, most);
    Stand* finest = nullptr;  // what goes to the tables, then what each is worth least: it comes closest
    for (auto& stand : stands_) {
      if (!is_free(stand)) continue;
      stand.count.high = stand.count.low + std::floor((most - given) / worth(stand));
      if (!finest || std::pair(!gathers(stand), worth(stand)) < std::pair(!gathers(*finest), worth(*finest)))
        finest = &stand;
    }
    if (finest) finest->count.low += std::ceil(std::max(0.0, least - given) / worth(*finest));
  }

  // One of each that such a room is none without, as far as that is not too many; what they are worth.
  template <typename IsFree, typename Worth>
  double give_essentials(IsFree is_free, Worth worth, double most) {
    double given = 0.0;
    for (auto& stand : stands_) {
      if (!is_free(stand) || stand.asked) continue;
      const bool is_given = stand.essential && given + worth(stand) <= most;
      stand.count.low = is_given ? 1.0 : 0.0;
      given += is_given ? worth(stand) : 0.0;
    }
    return given;
  }

  // Does it usually stand at something that was asked for?
  bool gathers_at_asked(const std::string& kind) const {
    const auto& arrangement = built_in_arrangements()->get(kinds_, kind, Mount::floor);
    return std::ranges::any_of(arrangement.ways, [&](const auto& way) {
      return std::ranges::any_of(way, [&](const Relation& relation) {
        return relation.kind == RelationKind::around && std::ranges::any_of(stands_, [&](const Stand& stand) {
                 return stand.asked && kinds_.is_a(stand.kind, relation.target);
               });
      });
    });
  }

  // One of each, as far as numbers that somebody gave leave room for it.
  void keep_essentials() {
    constexpr double nearly_empty = 0.12;  // share of the floor up to which nothing else than what was asked stands there
    if (asked_.occupancy && asked_.occupancy->high < nearly_empty) return;
    double things = 0.0;
    for (const auto& stand : stands_) things += stand.count.low;
    for (auto& stand : stands_) {
      const bool is_counted = (asked_.seats && is_seat(stand.kind)) || (asked_.shelves && is_shelf(stand.kind));
      if (!stand.essential || is_counted || stand.count.low >= 1.0 || stand.count.high < 1.0) continue;
      if (asked_.objects && things + 1.0 > asked_.objects->high) return;
      stand.count.low = 1.0;
      ++things;
    }
  }

  void tell_if_too_many(const std::string& measure, double fixed, const Range& wanted) {
    if (fixed > wanted.high)
      notes_.push_back(measure + ": at most " + std::to_string(static_cast<int>(wanted.high)) + " are asked for, and " +
                       std::to_string(static_cast<int>(fixed)) + " are counted by name");
  }

  void add_one_of(const std::vector<std::string>& kinds, double most) {
    const auto found = std::ranges::find_if(kinds, [&](const auto& kind) {
      return !kinds_.is_any_of(kind, excluded_) && !names_of_asked(kind);
    });
    if (found != kinds.end()) add(*found, most);
  }

  bool counts_as_asked(const std::string& kind) const {
    return std::ranges::any_of(stands_, [&](const Stand& stand) {
      return stand.asked && !stand.may_grow && kinds_.is_a(kind, stand.kind);
    });
  }

  // Counted by name, under its own or another one.
  bool names_of_asked(const std::string& kind) const {
    return std::ranges::any_of(stands_, [&](const Stand& stand) {
      return stand.asked && !stand.may_grow && (kinds_.is_a(stand.kind, kind) || kinds_.is_a(kind, stand.kind));
    });
  }

  void add(const std::string& kind, double most) {
    const auto same = std::ranges::find_if(stands_, [&](const Stand& stand) {
      return stand.kind == kind && (!stand.asked || stand.may_grow);
    });
    if (same != stands_.end()) {
      same->count.high = std::max(same->count.high, same->count.low + most);
      return;
    }
    Stand stand;
    stand.kind = kind;
    stand.name = free_name(stands_, kind);
    stand.mount = kinds_.get(kind).mount;
    stand.count = {0.0, most};
    stand.size = kinds_.get(kind).size;
    stand.description = kind;
    stands_.push_back(std::move(stand));
  }

  // Kinds that may be added in any number: what such rooms hold, then what most rooms may hold.
  std::vector<std::string> fillers(bool on_floor) const {
    std::vector<std::string> names;
    for (const auto& stand : stands_)
      if (!stand.asked || stand.may_grow) names.push_back(stand.kind);
    for (const auto* pieces : {&room_.core, &room_.extras, &room_.details})
      for (const auto& piece : *pieces) names.push_back(piece.any.front().first);
    for (const auto& name : complexity_words().made_up_with.at(on_floor ? "floor" : "small")) names.push_back(name);
    std::vector<std::string> chosen;
    for (const auto& name : names)
      if (may_fill(name, on_floor) && std::ranges::find(chosen, name) == chosen.end()) chosen.push_back(name);
    return chosen;
  }

  // How well a thing fills a floor: large ones that need little floor besides, to be used, do best.
  double filling(const std::string& name) const {
    constexpr double large = 0.5;  // m2
    const Kind& kind = kinds_.get(name);
    double zone = kind.zones.empty() ? 0.0 : std::numeric_limits<double>::infinity();
    for (const auto& each : kind.zones)
      zone = std::min(
          zone, each.depth * (each.side == Side::front || each.side == Side::back ? kind.size.x() : kind.size.y()));
    const double own = kind.size.x() * kind.size.y();
    return own / (own + zone) * std::min(1.0, own / large);
  }

  bool may_fill(const std::string& name, bool on_floor) const {
    const Kind& kind = kinds_.get(name);
    if (kind.lineage.empty() || kind.covers_window || kind.traits.flat) return false;
    if (on_floor != (kind.mount == Mount::floor) || names_of_asked(name) || kinds_.is_any_of(name, excluded_))
      return false;
    if (asked_.seats && is_seat(name)) return false;
    return !((asked_.shelves || any_shelf_is_asked()) && is_shelf(name));
  }

  bool any_shelf_is_asked() const {
    return std::ranges::any_of(stands_, [&](const Stand& stand) { return stand.asked && is_shelf(stand.kind); });
  }

  void fill_with_things(const Range& wanted) {
    double fixed = 0.0, possible = 0.0;
    for (const auto& stand : stands_) {
      if (stand.asked) fixed += stand.count.low;
      possible += stand.count.high;
    }
    tell_if_too_many("objects", fixed, wanted);
    std::size_t added = 0;
    const double missing = std::ceil(wanted.low - possible);
    if (missing <= 0.0) return;
    // Small things first: they need no floor.
    for (const bool on_floor : {false, true})
      for (const auto& name : fillers(on_floor)) {
        if (added++ >= most_fillers) return;
        add(name, std::max(2.0, std::ceil(missing / 3.0)));
      }
  }

  const Complexity& asked_;
  const brief::RoomKind& room_;
  const std::vector<std::string>& excluded_;
  const KindTable& kinds_;
  std::vector<Stand>& stands_;
  std::vector<std::string>& notes_;
};

}  // namespace

double middle_share(const Range& range) { return 0.5 * (range.low + std::min(1.0, range.high)); }

void meet_numbers(const Complexity& asked, const Means& means, std::vector<Stand>& stands,
                  std::vector<std::string>& notes) {
  Opener opener(asked, means, stands, notes);
  opener.open_numbers();
  if (asked.occupancy) opener.enlarge(*asked.occupancy);
}

void meet_occupancy(const Complexity& asked, const Means& means, double area, std::vector<Stand>& stands) {
  std::vector<std::string> notes;
  if (asked.occupancy) Opener(asked, means, stands, notes).fill_floor(*asked.occupancy, area);
}

std::optional<double> floor_for(const Complexity& asked, const std::vector<Stand>& stands, const KindTable& kinds) {
  if (!asked.occupancy) return std::nullopt;
  const double share = std::clamp(middle_share(*asked.occupancy), emptiest, fullest_chosen);
  const double covered = 0.5 * (least_footprint(stands, kinds) + most_footprint(stands, kinds));
  return covered / share;
}

}  // namespace roomgen::lab::compose
