#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/result.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/library/library.h"
#include "roomgen/lab/program.h"
#include "roomgen/scene/scene.h"

namespace roomgen::lab {

/// The things that may be put into a room, by kind: each with its mesh at its size. Poses mean nothing yet.
struct Stock {
  std::map<std::string, std::vector<Object>> articles;
  ModelTable models;
  std::vector<AssetInfo> assets;
  std::vector<std::string> missing;  ///< kinds of which there is nothing
};
/// Names of the kinds that a program may add, in alphabetical order. Of tags that cover many kinds (dishware) some
/// are chosen by the seed.
std::vector<std::string> kinds_to_stock(const ConstraintProgram& program, const KindTable& kinds, std::uint64_t seed = 0);
/// A kind to have in stock, and what is preferred of it.
struct StockWish {
  std::string kind;
  std::string description = {};   ///< "a white wooden desk"; empty: any
  std::optional<Vec3> size = {};  ///< metres; unset: as such things usually are
  std::optional<Mount> mount = {};
  bool asked = false;  ///< somebody named it: then a plain stand-in is better than nothing

  bool operator==(const StockWish&) const = default;
};
std::vector<StockWish> wishes_for(const std::vector<std::string>& kinds);
/// The best `per_kind` assets of a library for each wish, with their meshes. A kind of which the library has nothing
/// is left out; of several wishes for one kind all count.
Result<Stock> load_stock(const std::vector<StockWish>& wishes, const AssetLibrary& library, const KindTable& table,
                         std::size_t per_kind = 3);

/// The empty room of a program: its outline, or one of the size that it asks for (a range is drawn from), or as
/// large as such rooms are; with the openings that it gives, else those that such rooms have.
Result<Room> room_of(const ConstraintProgram& program, std::uint64_t seed, std::vector<std::string>& notes);

struct OptimiseProgress {
  int chain = 0;
  int step = 0;
  double violation = 0.0;  ///< of the best room so far
  double loss = 0.0;
  int things = 0;
};

struct OptimiseOptions {
  std::uint64_t seed = 0;
  int steps = 20000;          ///< moves tried in each chain
  int chains = 2;             ///< restarts; the best room counts
  int threads = 0;            ///< 0: one a core; the result does not depend on it
  bool cluster_moves = true;  ///< things with all that is up against them move as one
  bool object_moves = true;   ///< for comparisons
  CancelToken cancel = {};    ///< with an end of its own: a budget of time
  std::function<void(const OptimiseProgress&)> on_progress = {};  ///< on the threads of the chains, one at a time
};

/// What became of a constraint.
struct ConstraintVerdict {
  std::string name;
  bool held = false;
  double amount = 0.0;               ///< by which it is missed; for one that holds, 0
  std::vector<std::string> objects;  ///< ids of the things that it counts or measures
  std::string text;                  ///< the constraint, for people
};

/// A moment of the search: after so many steps of its chain the best room was worth this.
struct OptimisePoint {
  int step = 0;
  double violation = 0.0;
  double loss = 0.0;
};

struct Optimisation {
  Scene scene;   ///< valid (docs/constraints.md), with relations that hold; incomplete if the work was cut
  std::vector<ConstraintVerdict> constraints;
  std::map<std::string, double> scores;
  double violation = 0.0;  ///< the sum of what constraints miss
  double loss = 0.0;
  double occupancy = 0.0;  ///< floor covered by all but rugs, over all floor
  long long moves = 0;     ///< tried, in all chains
  long long accepted = 0;
  std::array<long long, 11> tried_by_kind{}, accepted_by_kind{};  ///< see optimise_move_names()
  std::vector<OptimisePoint> curve;  ///< of the chain that won
};
const std::array<std::string, 11>& optimise_move_names();

/// Finds a room for a program by simulated annealing (Kirkpatrick et al. 1983; moves after InfiniBench's supplement,
/// section C): things are added, removed, exchanged for others, moved, turned, put against other planes and targets, and
/// swapped, and so are clusters: a thing with all that stands on, in or against it. A state that breaks a hard rule
/// is left at once; fewer violations go before lower scores; the best room so far is always valid. Equal input
/// gives equal rooms unless the work is cut by time. An error when the program or the room is unsound, or a bound
/// asks for more things than a room may hold.
///
/// How costs are measured stands in docs/programs.md and src/optimise/measures.h.
Result<Optimisation> optimise(const ConstraintProgram& program, const Room& room, const Stock& stock,
                              const KindTable& kinds, const OptimiseOptions& options = {});

/// Constraints that cannot be had together, as far as short searches tell: each of them by itself taken out, the others can.
/// Found by leaving out one after the other (a deletion filter: Chinneck and Dravnieks 1991); names in the program's
/// order. Empty if all can be had, or if the search was cut.
Result<std::vector<std::string>> conflict(const ConstraintProgram& program, const Room& room, const Stock& stock,
                                          const KindTable& kinds, const OptimiseOptions& options = {});

}  // namespace roomgen::lab
