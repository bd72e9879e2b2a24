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

}  // namespace roomgen::create::detail
