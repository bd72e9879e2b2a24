#include "search.h"

#include <algorithm>

#include "part_roles.h"

namespace roomgen::create::detail {

namespace {

// In triangles or so: a second or two.
constexpr std::uint64_t most_work = 12'000'000;

}  // namespace

bool Trials::exhausted() const {
  return from_.assembly.work() > most_work;
}

// How far corners of boxes went, in metres: most for the part that went furthest, and for those
// that others rest on.
double Trials::effort(const Assembly& changed) const {
  double furthest = 0.0, sum = 0.0;
  const auto &before = from_.assembly.parts(), &after = changed.parts();
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (before[k].id == after[k].id) continue;
    const double way = std::max((before[k].box().low - after[k].box().low).norm(),
                                (before[k].box().high - after[k].box().high).norm());
    const int level = from_.judgement.level[k];
    double weight = level < 0 ? 1.0 : 1.0 + 1.0 / (1.0 + level);
    if (is_decorative(before[k].label)) weight *= 0.7;
    furthest = std::max(furthest, weight * way);
    sum += weight * way;
  }
  return furthest + 0.1 * sum;
}

void Trials::consider(Assembly changed, const std::string& what) {
  Judgement judgement = judge(changed, links_, options_);
  if (judgement.penalty() >= from_.judgement.penalty() - 1e-6) return;
  const double cost = judgement.penalty() + effort(changed);
  if (cost >= least_ - 1e-9) return;
  least_ = cost;
  what_ = what;
  best_ = State{std::move(changed), std::move(judgement)};
}

}  // namespace roomgen::create::detail
