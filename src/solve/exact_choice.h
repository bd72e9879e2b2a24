#pragma once

#include <map>
#include <optional>
#include <vector>

#include "place.h"

namespace roomgen {

/// A pose that passed the cheap tests, with its score.
struct Scored {
  Pose pose;
  PlacementTerms terms;
  double merit = 0.0;  ///< by which it is chosen
};

/// Is the pose like one of those that are left out?
bool is_excepted(const Object& object, const Pose& pose, const PlaceOptions& options);

/// Walks through candidates in the order of choice and tests each on meshes and reachability. Near
/// one that failed, others will probably fail too; near one that passed, others are no real
/// alternative: both come after those elsewhere. Only when the first to pass has clearly less merit than
/// some that were put off are those tried before it: a fine grid, with many failures close together,
/// must not be driven from a suggestion.
class ExactChoice {
 public:
  /// All but `order` must outlive this. `clearly` is a difference of merit.
  ExactChoice(Layout& layout, const PlacementTask& task, const std::vector<Scored>& scored,
              std::vector<std::size_t> order, double clearly,
              const PlaceOptions& options)
      : layout_(layout),
        task_(task),
        object_(task.object),
        scored_(scored),
        order_(std::move(order)),
        clearly_(clearly),
        cancel_(options.cancel),
        even_useless_(options.even_useless),
        tests_left_(options.max_exact_tests) {}

  /// The next candidate that passes, if any: an index of `scored`.
  std::optional<std::size_t> next();

 private:
  std::pair<int, int> cell(std::size_t i) const;
  int failures_near(std::size_t i) const;
  bool is_like_one_passed(std::size_t i) const;
  std::size_t accepted(std::size_t i);
  std::optional<std::size_t> first_deferred_that_passes(double bar);
  bool may_test() const { return tests_left_ > 0 && !cancel_.cancelled(); }
  bool passes(std::size_t i);

  Layout& layout_;
  const PlacementTask& task_;
  const Object& object_;
  const std::vector<Scored>& scored_;
  std::vector<std::size_t> order_, deferred_, passed_;
  std::map<std::pair<int, int>, int> failures_;
  std::size_t next_ = 0, next_deferred_ = 0;
  double clearly_;
  const CancelToken& cancel_;
  const bool even_useless_;
  int tests_left_;
};

}  // namespace roomgen
