#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/random.h"
#include "layout.h"
#include "roomgen/base/cancel.h"
#include "roomgen/scene/problem.h"
#include "roomgen/solve/solve.h"

namespace roomgen {

struct ImproveOptions {
  PlaceOptions place;
  Improvement mode = Improvement::minimal;
  int rounds = 60;  ///< at most; the search ends early when nothing is left to win
  /// Weight of the random part of degrees while searching.
  double noise = 0.6;
  CancelToken cancel;
};

/// Wins back objects without a place and lost constraints: takes a troubled object, what it depends
/// on and some neighbours out (never locked ones), puts them back in another way, and keeps the
/// result if it is better (large neighbourhood search, Shaw 1998). Things that nobody asked for may
/// lose their place to those that were. `tasks` are all objects in placement order; `reasons` says why
/// some are not in the layout, and is kept up to date. Returns the rounds used.
int improve(Layout& layout, const std::vector<PlacementTask>& tasks,
            std::map<std::string, std::string>& reasons, const ImproveOptions& options,
            Random& random);

/// Places each thing once more by itself, without chance, and keeps what is better: searches leave
/// some a little off.
void polish(Layout& layout, const std::vector<PlacementTask>& tasks, PlaceOptions options,
            const CancelToken& cancel, Random& random);

/// Places a small thing on a support that is full by moving what stands there already: all of it,
/// with the newcomer, is arranged anew so that every constraint holds, or else all that was wished
/// for, or else so that everything at least stands on its support. `tasks` are the things of the
/// layout in placement order; locked ones and those without a task stay where they are, and if that will do
/// also those that somebody put there. Tells whether the newcomer is in the layout now; if not, nothing has moved.
bool make_room(Layout& layout, const PlacementTask& newcomer,
               const std::vector<PlacementTask>& tasks, const CancelToken& cancel, Random& random);

}  // namespace roomgen
