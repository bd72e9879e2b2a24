#include "exact_choice.h"

#include <algorithm>
#include <limits>

#include "propose.h"

namespace roomgen {

namespace {

constexpr double neighbourhood = 0.25;

}  // namespace

bool is_excepted(const Object& object, const Pose& pose, const PlaceOptions& options) {
  return std::any_of(options.except.begin(), options.except.end(),
                     [&](const Pose& other) { return are_alike(object, pose, other); });
}

std::optional<std::size_t> ExactChoice::next() {
  while (next_ < order_.size() && may_test()) {
    const std::size_t i = order_[next_++];
    if (failures_near(i) >= 2 || is_like_one_passed(i)) {
      deferred_.push_back(i);
    } else if (passes(i)) {
      const auto better = first_deferred_that_passes(scored_[i].merit + clearly_);
      if (better) --next_;
      return accepted(better.value_or(i));
    }
  }
  const auto last = first_deferred_that_passes(std::numeric_limits<double>::lowest());
  if (!last) return std::nullopt;
  return accepted(*last);
}

std::pair<int, int> ExactChoice::cell(std::size_t i) const {
  const Vec2 index = (scored_[i].pose.position / neighbourhood).array().floor();
  return {static_cast<int>(index.x()), static_cast<int>(index.y())};
}

int ExactChoice::failures_near(std::size_t i) const {
  const auto found = failures_.find(cell(i));
  return found == failures_.end() ? 0 : found->second;
}

bool ExactChoice::is_like_one_passed(std::size_t i) const {
  return std::any_of(passed_.begin(), passed_.end(), [&](std::size_t j) {
    return are_alike(object_, scored_[i].pose, scored_[j].pose);
  });
}

std::size_t ExactChoice::accepted(std::size_t i) {
  passed_.push_back(i);
  return i;
}

// Of those put off, while none has been accepted: the first above `bar` that passes.
std::optional<std::size_t> ExactChoice::first_deferred_that_passes(double bar) {
  while (passed_.empty() && next_deferred_ < deferred_.size() && may_test()) {
    const std::size_t i = deferred_[next_deferred_];
    if (scored_[i].merit < bar) break;
    ++next_deferred_;
    if (passes(i)) return i;
  }
  return std::nullopt;
}

bool ExactChoice::passes(std::size_t i) {
  --tests_left_;
  Layout::Candidate candidate = layout_.candidate(task_);
  candidate.even_useless = even_useless_;
  candidate.object = at_pose(object_, scored_[i].pose);
  const bool passed{layout_.fits_exactly(candidate)};
  if (!passed) ++failures_[cell(i)];
  return passed;
}

}  // namespace roomgen
