#include "search.h"

#include <algorithm>

#include "part_roles.h"

namespace roomgen::create::detail {

namespace {

// In triangles or so: a second or two.
constexpr std::uint64_t most_work = 4'000'000;
// A part that is only lengthened changes the whole less than one that goes elsewhere.
constexpr double lengthened = 0.25, thickened = 2.0, one_end = 0.1;
// What a contact more is worth in metres, and how many count: a rung shall reach both posts.
constexpr double contact_worth = 0.0125, most_contacts = 8.0;

// Along its greatest extent, as legs and rungs grow; a seat does not grow thicker.
bool lengthwise(const Bounds3& before, const Bounds3& after) {
  int axis = 0;
  (after.size() - before.size()).cwiseAbs().maxCoeff(&axis);
  return before.size()[axis] >= 0.8 * before.size().maxCoeff();
}

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
    const double low = (before[k].box().low - after[k].box().low).norm();
    const double high = (before[k].box().high - after[k].box().high).norm();
    double way = std::max(low, high);
    const double middle = (before[k].box().center() - after[k].box().center()).norm();
    if (std::min({low, high, middle}) < one_end * way)
      way *= lengthwise(before[k].box(), after[k].box()) ? lengthened : thickened;
    const int level = from_.judgement.level[k];
    double weight = level < 0 ? 1.0 : 1.0 + 1.0 / (1.0 + level);
    if (is_decorative(before[k].label)) weight *= 0.7;
    furthest = std::max(furthest, weight * way);
    sum += weight * way;
  }
  return furthest + 0.1 * sum;
}

double Trials::gained(const Assembly& changed, const Judgement& judgement) const {
  double contacts = 0.0;
  for (std::size_t k = 0; k < changed.parts().size(); ++k)
    if (from_.assembly.parts()[k].id != changed.parts()[k].id)
      contacts += static_cast<double>(judgement.contacts[k].size()) -
                  static_cast<double>(from_.judgement.contacts[k].size());
  return contact_worth * std::clamp(contacts, 0.0, most_contacts);
}

void Trials::consider(Assembly changed, const std::string& what) {
  Judgement judgement = judge(changed, links_, options_);
  if (judgement.penalty() >= from_.judgement.penalty() - 1e-6) return;
  const double cost = judgement.penalty() + effort(changed) - gained(changed, judgement);
  if (cost >= least_ - 1e-9) return;
  least_ = cost;
  what_ = what;
  best_ = State{std::move(changed), std::move(judgement)};
}

}  // namespace roomgen::create::detail
