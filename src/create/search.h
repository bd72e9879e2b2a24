#pragma once

#include <optional>
#include <string>
#include <vector>

#include "judgement.h"

namespace roomgen::create::detail {

/// An assembly with what is wrong with it.
struct State {
  Assembly assembly;
  Judgement judgement;
};

/// Keeps the best of the changes to a state that were tried. A change is better when it leaves less
/// wrong; among equals the smaller one, that of parts that carry little, wins.
class Trials {
 public:
  Trials(const State& from, const std::vector<Link>& links, const ValidateOptions& options)
      : from_(from), links_(links), options_(options) {}

  const State& from() const { return from_; }
  const std::vector<Link>& links() const { return links_; }
  const ValidateOptions& options() const { return options_; }
  /// Has so much been computed that no more should be tried?
  bool exhausted() const;

  void consider(Assembly changed, const std::string& what);
  std::optional<State> best() && { return std::move(best_); }
  const std::string& what() const { return what_; }

 private:
  double effort(const Assembly& changed) const;
  double gained(const Assembly& changed, const Judgement& judgement) const;

  const State& from_;
  const std::vector<Link>& links_;
  const ValidateOptions& options_;
  std::optional<State> best_;
  std::string what_;
  double least_ = 1e300;
};

/// The height that most of the parts which should reach the floor do reach; of the lowest point
/// when none should.
double floor_level(const Assembly& assembly, const std::vector<Link>& links);
/// All components up or down, so that this height becomes 0.
void shift_level(Assembly& assembly, double height);
/// Lifts or shortens what is below the floor.
void try_lifting(Trials& trials);

/// Widens what stands on the ground, or moves it and what is above it over each other.
void try_steadying(Trials& trials);

/// Links that are to be closed in a state: the open ones, lowest first, and one for each piece that
/// is joined to nothing, chosen by the map or by nearness.
std::vector<Link> links_to_close(const State& state, const std::vector<Link>& links);

/// Tries to close one of the links by moving or stretching either side, alone, with its copies'
/// links or with all that hangs on it.
void try_closing(Trials& trials, const std::vector<Link>& to_close, std::size_t which);

}  // namespace roomgen::create::detail
