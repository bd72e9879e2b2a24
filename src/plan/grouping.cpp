#include "grouping.h"

#include <algorithm>
#include <cmath>

#include "roomgen/base/text.h"

namespace roomgen::plan {

namespace {

using composition::Composition;
using composition::Values;

// What a group is worth: things that stand in their place, against parts that nobody has and things that are left over.
constexpr double of_missing = 0.4, of_misfit = 0.6, of_other_kind = 0.3, least_gain = 0.5;
constexpr int most_values = 40;

bool is_placed_with_anchor(Mount mount) { return mount != Mount::surface; }

// Said of a place at the anchor that any of its patterns gives.
bool is_given_by_pattern(RelationKind kind) {
  switch (kind) {
    case RelationKind::near:
    case RelationKind::next_to:
    case RelationKind::around:
    case RelationKind::side_of:
    case RelationKind::face_to:
    case RelationKind::on:
      return true;
    default:
      return false;
  }
}

bool is_free(const Draft& draft) { return draft.item.group.empty() && draft.item.quantity > 0; }

// One thing more of the anchor's kind wants its share, too.
int anchors_like(const std::vector<Draft>& drafts, const Draft& anchor) {
  int count = 0;
  for (const auto& draft : drafts)
    if (is_free(draft) && draft.item.category == anchor.item.category) count += draft.item.quantity;
  return std::max(1, count);
}

std::string key_of(const Composition& composition, const Values& values) {
  std::string key = composition.name;
  for (const auto& [name, value] : values)
    if (const double* number = std::get_if<double>(&value)) key += "|" + name + "=" + format_number(*number, 3);
  return key;
}

// A thing of a draft, and the rest of it.
Draft split_off(Draft& draft, int quantity, const std::string& group, const std::string& part) {
  Draft taken = draft;
  taken.item.quantity = quantity;
  taken.item.group = group;
  taken.item.part = part;
  draft.item.quantity -= quantity;
  return taken;
}

}  // namespace

Grouping::Grouping(const KindTable& kinds) : kinds_(kinds) {}

const Grouping::Counts& Grouping::counts_of(const Composition& composition, const Values& values) {
  const auto [at, is_new] = known_.try_emplace(key_of(composition, values));
  if (!is_new) return at->second;
  const auto arranged =
      composition::arrange(composition, values, {*composition::built_in_compositions(), kinds_});
  if (!arranged) return at->second;
  for (const auto& member : arranged->members) {
    auto& counts = at->second;
    const auto same = std::find_if(counts.begin(), counts.end(), [&](const auto& one) { return one.part == member.part; });
    if (same != counts.end()) ++same->count;
    else counts.push_back({member.part, member.category, member.mount, 1, member.spare});
  }
  return at->second;
}

bool Grouping::belongs(const Draft& draft, const PartCount& part, const Draft& anchor) const {
  if (!is_free(draft) || &draft == &anchor || draft.item.mount != part.mount) return false;
  if (draft.formation && !draft.is_usual_formation) return false;
  if (!is_kin(draft.item.category, part.kind)) return false;
  return std::all_of(draft.demands.begin(), draft.demands.end(), [&](const brief::Demand& demand) {
    return demand.mention != brief::Demand::none && demand.mention == anchor.mention &&
           is_given_by_pattern(demand.kind);
  });
}

// "table" is as good as a dining table.
bool Grouping::is_kin(const std::string& category, const std::string& kind) const {
  return kinds_.is_a(category, kind) || kinds_.is_a(kind, category);
}

int Grouping::available(const PartCount& part, const std::vector<Draft>& drafts, std::size_t anchor) const {
  int count = 0;
  for (const auto& draft : drafts)
    if (belongs(draft, part, drafts[anchor])) count += draft.item.quantity;
  const int anchors = anchors_like(drafts, drafts[anchor]);
  return (count + anchors - 1) / anchors;
}

double Grouping::gain_of(const Counts& counts, const std::vector<Draft>& drafts, std::size_t anchor) const {
  double gain = 0.0;
  for (std::size_t i = 1; i < counts.size(); ++i) {
    if (!is_placed_with_anchor(counts[i].mount)) continue;
    const int there = available(counts[i], drafts, anchor);
    gain += std::min(there, counts[i].count);
    if (there == 0) gain -= counts[i].spare == 0 ? of_missing * counts[i].count : 0.0;
    else gain -= of_misfit * std::abs(there - counts[i].count);
  }
  return gain;
}

Grouping::Fit Grouping::fit(const Composition& composition, const std::vector<Draft>& drafts, std::size_t anchor) {
  Fit best{&composition, {}, counts_of(composition, {}), 0.0};
  best.gain = best.counts.empty() ? -1.0 : gain_of(best.counts, drafts, anchor);
  for (const auto& parameter : composition.parameters) {
    if (!parameter.choices.empty() || parameter.most - parameter.least > most_values) continue;
    for (double value = parameter.least; value <= parameter.most; value += 1.0) {
      Values values = best.values;
      values[parameter.name] = value;
      const Counts& counts = counts_of(composition, values);
      if (counts.empty()) continue;
      const double gain = gain_of(counts, drafts, anchor);
      if (gain > best.gain + 1e-9) best = {&composition, values, counts, gain};
    }
  }
  return best;
}

void Grouping::make_group(const Fit& fit, std::vector<Draft>& drafts, std::size_t anchor, const brief::Brief& brief,
                          Plan& plan) {
  PlanGroup group;
  group.composition = fit.composition->name;
  const auto number = std::count_if(plan.groups.begin(), plan.groups.end(), [&](const PlanGroup& one) {
    return one.composition == group.composition;
  });
  group.id = group.composition + "-" + std::to_string(number);
  group.parameters = fit.values;
  group.asked = drafts[anchor].item.asked;
  std::vector<Draft> taken;
  for (std::size_t i = 1; i < fit.counts.size(); ++i) {
    const PartCount& part = fit.counts[i];
    int wanted = std::min(part.count, available(part, drafts, anchor));
    const bool is_dressing = !is_placed_with_anchor(part.mount) && !brief.bare && !kinds_.is_any_of(part.kind, brief.excluded);
    if (wanted == 0 && !is_dressing) group.without.insert(part.part);
    for (auto& draft : drafts) {
      if (wanted == 0 || !belongs(draft, part, drafts[anchor])) continue;
      const int some = std::min(wanted, draft.item.quantity);
      // A number that was asked for stays.
      if (draft.item.asked)
        for (const auto& [name, value] : fit.values) group.fixed.insert(name);
      taken.push_back(split_off(draft, some, group.id, part.part));
      wanted -= some;
    }
  }
  Draft first = split_off(drafts[anchor], 1, group.id, fit.counts.front().part);
  const auto after = drafts.begin() + static_cast<std::ptrdiff_t>(anchor) + 1;
  taken.insert(taken.begin(), std::move(first));
  drafts.insert(after, std::make_move_iterator(taken.begin()), std::make_move_iterator(taken.end()));
  plan.groups.push_back(std::move(group));
}

void Grouping::run(std::vector<Draft>& drafts, const brief::Brief& brief, Plan& plan) {
  constexpr int most_groups = 200;
  plan.groups.clear();
  for (auto& draft : drafts) draft.item.group.clear(), draft.item.part.clear();
  const auto& known = composition::built_in_compositions();
  for (int n = 0; known && n < most_groups; ++n) {
    Fit best;
    std::size_t anchor = 0;
    for (std::size_t i = 0; i < drafts.size(); ++i) {
      if (!is_free(drafts[i]) || drafts[i].item.mount != Mount::floor) continue;
      for (const auto& [name, one] : *known) {
        const Counts& counts = counts_of(one, {});
        if (counts.empty() || !is_kin(drafts[i].item.category, counts.front().kind)) continue;
        Fit found = fit(one, drafts, i);
        // Rather the composition for just that.
        if (!kinds_.is_a(drafts[i].item.category, counts.front().kind)) found.gain -= of_other_kind;
        if (found.gain > std::max(best.gain, least_gain) + 1e-9) best = std::move(found), anchor = i;
      }
    }
    if (!best.composition) break;
    make_group(best, drafts, anchor, brief, plan);
    std::erase_if(drafts, [](const Draft& draft) { return draft.item.quantity < 1; });
  }
}

}  // namespace roomgen::plan
