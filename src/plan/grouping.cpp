#include "grouping.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "composition/plan_groups.h"
#include "gathering.h"
#include "roomgen/base/text.h"

namespace roomgen::plan {

namespace {

using composition::Composition;
using composition::Values;

// What a group is worth: things that stand in their place, against parts that nobody has and things
// that are left over.
constexpr double of_missing = 0.15, of_misfit = 0.6, of_other_kind = 0.3, least_gain = 0.5;
constexpr int most_values = 40;

bool is_placed_with_anchor(Mount mount) {
  return mount != Mount::surface;
}

// Said of a place at the anchor that any of its patterns gives.
bool is_given_by_pattern(RelationKind kind) {
  switch (kind) {
    case RelationKind::near:
    case RelationKind::next_to:
    case RelationKind::around:
    case RelationKind::side_of:
    case RelationKind::in_front_of:
    case RelationKind::face_to:
    case RelationKind::on:
      return true;
    default:
      return false;
  }
}

bool is_free(const Draft& draft) {
  return draft.item.group.empty() && draft.item.quantity > 0;
}

std::string key_of(const Composition& composition, const Values& values) {
  std::string key = composition.name;
  for (const auto& [name, value] : values)
    if (const double* number = std::get_if<double>(&value))
      key += "|" + name + "=" + format_number(*number, 3);
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
    const auto same = std::find_if(counts.begin(), counts.end(),
                                   [&](const auto& one) { return one.part == member.part; });
    if (same != counts.end())
      ++same->count;
    else
      counts.push_back({member.part, member.category, member.mount, 1, member.spare});
  }
  return at->second;
}

bool Grouping::belongs(const Draft& draft, const PartCount& part, const Draft& anchor) const {
  if (!is_free(draft) || draft.item.mount != part.mount) return false;
  if (draft.formation && !draft.is_usual_formation) return false;
  if (!is_kin(draft.item.category, part.kind)) return false;
  if (&draft == &anchor) return true;
  return std::all_of(draft.demands.begin(), draft.demands.end(), [&](const brief::Demand& demand) {
    return demand.mention != brief::Demand::none && demand.mention == anchor.mention &&
           is_given_by_pattern(demand.kind);
  });
}

// "table" is as good as a dining table, which people mean by it.
bool Grouping::is_kin(const std::string& category, const std::string& kind) const {
  if (kinds_.is_a(category, kind)) return true;
  const Kind& special = kinds_.get(kind);
  return special.usual && special.parent == category;
}

// Of each draft the share of one such group: all of the anchor's kind want theirs.
std::vector<int> Grouping::shares(const Counts& counts, const std::vector<Draft>& drafts,
                                  std::size_t anchor) const {
  int anchors = 0, anchors_here = 0;
  for (const auto& draft : drafts)
    if (is_free(draft) && draft.item.category == drafts[anchor].item.category)
      anchors += draft.item.quantity;
  for (const auto& one : counts)
    if (one.mount == Mount::floor && kinds_.is_a(one.kind, counts.front().kind))
      anchors_here += one.count;
  std::vector<int> shares;
  for (const auto& draft : drafts) {
    const bool is_anchor = draft.item.category == drafts[anchor].item.category;
    const int quantity = is_free(draft) ? draft.item.quantity : 0;
    const int share = (quantity * anchors_here + anchors - 1) / std::max(1, anchors);
    shares.push_back(is_anchor ? quantity : std::min(quantity, share));
  }
  return shares;
}

std::vector<Grouping::Use> Grouping::uses_of(const Counts& counts, const std::vector<Draft>& drafts,
                                             std::size_t anchor, std::vector<int>& left) const {
  left = shares(counts, drafts, anchor);
  std::vector<Use> uses = {{0, anchor, 1}};
  --left[anchor];
  for (std::size_t i = 0; i < counts.size(); ++i) {
    int wanted = counts[i].count - (i == 0 ? 1 : 0);
    for (std::size_t d = 0; d < drafts.size() && wanted > 0; ++d) {
      const int some = std::min(wanted, left[d]);
      if (some <= 0 || !belongs(drafts[d], counts[i], drafts[anchor])) continue;
      uses.push_back({i, d, some});
      left[d] -= some;
      wanted -= some;
    }
  }
  return uses;
}

double Grouping::gain_of(const Counts& counts, const std::vector<Draft>& drafts,
                         std::size_t anchor) const {
  std::vector<int> got(counts.size(), 0), left;
  std::set<std::size_t> used;
  for (const auto& use : uses_of(counts, drafts, anchor, left)) {
    got[use.part] += use.quantity;
    if (use.draft != anchor) used.insert(use.draft);
  }
  double gain = -1.0;  // the anchor itself is no gain
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (!is_placed_with_anchor(counts[i].mount)) continue;
    gain += got[i];
    const int missing = counts[i].count - got[i];
    if (missing > 0 && counts[i].spare == 0 && (got[i] == 0 || i == 0)) return -1.0;
    if (missing > 0) gain -= got[i] == 0 ? of_missing : of_misfit * missing;
  }
  for (const std::size_t draft : used) gain -= of_misfit * left[draft];
  return gain;
}

Grouping::Fit Grouping::fit(const Composition& composition, const std::vector<Draft>& drafts,
                            std::size_t anchor) {
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

// "nothing on the desk", "no cushions", "a bare room".
bool Grouping::may_dress(const std::string& kind, const brief::Brief& brief) const {
  return !brief.bare && !kinds_.is_any_of(kind, brief.excluded) &&
         std::none_of(brief.limits.begin(), brief.limits.end(), [&](const brief::Limit& limit) {
           if (!limit.category.empty()) return kinds_.is_a(kind, limit.category);
           return limit.mount ? *limit.mount == Mount::surface : limit.on != brief::no_mention;
         });
}

void Grouping::make_group(const Fit& fit, std::vector<Draft>& drafts, std::size_t anchor,
                          const brief::Brief& brief, Plan& plan) {
  PlanGroup group;
  group.composition = fit.composition->name;
  const auto number =
      std::count_if(plan.groups.begin(), plan.groups.end(),
                    [&](const PlanGroup& one) { return one.composition == group.composition; });
  group.id = group.composition + "-" + std::to_string(number);
  group.parameters = fit.values;
  group.asked = drafts[anchor].item.asked;
  std::vector<Draft> taken;
  std::vector<bool> has(fit.counts.size(), false);
  std::vector<int> left;
  for (const auto& use : uses_of(fit.counts, drafts, anchor, left)) {
    has[use.part] = true;
    taken.push_back(
        split_off(drafts[use.draft], use.quantity, group.id, fit.counts[use.part].part));
    // Numbers that were asked for stay.
    if (taken.back().item.asked)
      for (const auto& parameter : fit.composition->parameters) group.fixed.insert(parameter.name);
  }
  for (std::size_t i = 0; i < fit.counts.size(); ++i) {
    const PartCount& part = fit.counts[i];
    const bool is_dressing = !is_placed_with_anchor(part.mount) && may_dress(part.kind, brief);
    if (!has[i] && !is_dressing) group.without.insert(part.part);
  }
  const auto after = drafts.begin() + static_cast<std::ptrdiff_t>(anchor) + 1;
  drafts.insert(after, std::make_move_iterator(taken.begin()),
                std::make_move_iterator(taken.end()));
  plan.groups.push_back(std::move(group));
}

Grouping::Floor Grouping::floor_of(std::vector<Draft> drafts, const brief::Brief& brief,
                                   const std::string& prompt) {
  Plan plan;
  plan.prompt = prompt;
  run(drafts, brief, plan);
  Floor floor;
  for (const auto& draft : drafts) {
    if (draft.item.group.empty()) floor.area += floor_area(draft.item, kinds_);
    plan.items.push_back(draft.item);
  }
  composition::complete_groups(plan, kinds_);
  for (const auto& group : plan.groups) {
    const auto ways = composition::ways_to_stand(plan, group, kinds_, {});
    if (!ways) continue;
    const Bounds2 box = composition::box_of(ways->front(), kinds_);
    floor.area += box.size().prod();
    if (box.size().prod() > floor.largest.prod()) floor.largest = box.size();
  }
  return floor;
}

void Grouping::run(std::vector<Draft>& drafts, const brief::Brief& brief, Plan& plan) {
  constexpr int most_groups = 200;
  plan.groups.clear();
  for (auto& draft : drafts) draft.item.group.clear(), draft.item.part.clear();
  const auto& known = composition::built_in_compositions();
  const std::string wish = lower(plan.prompt), room = brief.type;
  for (int n = 0; known && n < most_groups; ++n) {
    Fit best;
    std::size_t anchor = 0;
    for (std::size_t i = 0; i < drafts.size(); ++i) {
      if (!is_free(drafts[i]) || drafts[i].item.mount != Mount::floor) continue;
      for (const auto& [name, one] : *known) {
        const Counts& counts = counts_of(one, {});
        if (counts.empty() || !is_kin(drafts[i].item.category, counts.front().kind)) continue;
        const double ready = readiness(one, room, wish);
        if (ready <= 0.0) continue;
        Fit found = fit(one, drafts, i);
        found.gain *= ready;
        // Rather the composition for just that.
        if (drafts[i].item.category != counts.front().kind) found.gain -= of_other_kind;
        if (found.gain > std::max(best.gain, least_gain) + 1e-9)
          best = std::move(found), anchor = i;
      }
    }
    if (!best.composition) break;
    make_group(best, drafts, anchor, brief, plan);
    std::erase_if(drafts, [](const Draft& draft) { return draft.item.quantity < 1; });
  }
}

}  // namespace roomgen::plan
