#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/random.h"
#include "place.h"
#include "roomgen/base/cancel.h"
#include "roomgen/scene/problem.h"

namespace roomgen {

struct ImproveOptions {
  PlaceOptions place;
  Improvement mode = Improvement::minimal;
  int rounds = 60;  ///< at most; the search ends early when nothing is left to win
  /// Weight of the random part of degrees while searching.
  double noise = 0.6;
  CancelToken cancel;
};

/// What a layout is worth: first how many things that were asked for found a place, then how many of
/// the wishes hold, then how many things there are at all, then how little of what binds was moved, then
/// how many constraints hold, then how well.
struct LayoutQuality {
  int asked = 0;
  int wishes = 0;
  int placed = 0;
  double displaced = 0.0;  ///< metres in all, those of earlier things weighing up to twice as much
  int held = 0;
  double degree = 0.0;

  bool better_than(const LayoutQuality& other) const;
  /// The same or more of everything that is counted; the degree may be worse.
  bool as_good_as(const LayoutQuality& other) const;
};
LayoutQuality quality(const Layout& layout, const std::vector<PlacementTask>& tasks);

/// Wins back objects without a place and lost constraints: takes a troubled object, what it depends
/// on and some neighbours out (never locked ones), puts them back in another way, and keeps the
/// result if it is better (large neighbourhood search, Shaw 1998). Things that nobody asked for may
/// lose their place to those that were. `tasks` are all objects in placement order; `reasons` says why some are not in the layout, and is kept up to date. Returns
/// the rounds used.
int improve(Layout& layout, const std::vector<PlacementTask>& tasks,
            std::map<std::string, std::string>& reasons, const ImproveOptions& options,
            Random& random);

/// Places each thing once more by itself, without chance, and keeps what is better: searches leave
/// some a little off.
void polish(Layout& layout, const std::vector<PlacementTask>& tasks, PlaceOptions options,
            const CancelToken& cancel, Random& random);

}  // namespace roomgen
