#include "fitting.h"

#include <algorithm>
#include <set>

#include "blocks.h"
#include "gathering.h"
#include "roomgen/base/text.h"

namespace roomgen::plan {

namespace {

using composition::Composition;
using composition::Values;

// What a group is worth: things that stand in their place, against parts that nobody has and things
// that are left over.
constexpr double of_missing = 0.15, of_misfit = 0.6, of_other_kind = 0.3, of_very_kind = 1.0, of_dressing = 0.4, least_gain = 0.5;
constexpr int most_values = 40;

std::string key_of(const Composition& composition, const Values& values) {
  std::string key = composition.name;
  for (const auto& [name, value] : values)
    if (const double* number = std::get_if<double>(&value))
      key += "|" + name + "=" + format_number(*number, 3);
  return key;
}

}  // namespace

const PartCounts& Fitting::counts_of(const Composition& composition, const Values& values) {
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
      counts.push_back({member.part, member.category, member.mount, 1, member.spare, member.size});
  }
  return at->second;
}

// Told to be at this anchor, or at something that the group has as well; and near others, which is little.
bool Fitting::is_told_within(const Draft& draft, const PartCounts& counts, const std::vector<Draft>& drafts,
                              std::size_t anchor) const {
  const auto is_within = [&](const brief::Demand& demand) {
    if (demand.mention == brief::Demand::none) return false;
    return demand.mention == drafts[anchor].mention ||
           std::any_of(drafts.begin(), drafts.end(), [&](const Draft& other) {
             return other.mention == demand.mention && is_free(other) &&
                    std::any_of(counts.begin(), counts.end(), [&](const PartCount& part) {
                      return is_kin(other.item.category, part.kind);
                    });
           });
  };
  bool is_tied = draft.demands.empty(), is_tied_elsewhere = false;
  for (const auto& demand : draft.demands) {
    const bool within = is_place_at(demand.kind) && is_within(demand);
    is_tied = is_tied || within;
    is_tied_elsewhere = is_tied_elsewhere || (!within && demand.kind != RelationKind::near);
  }
  return is_tied && !is_tied_elsewhere;
}

bool Fitting::belongs(const Draft& draft, const PartCount& part) const {
  if (!is_free(draft) || draft.item.mount != part.mount) return false;
  // A plain word is meant as what stands there: "stools" at a bar.
  return is_kin(draft.item.category, part.kind) || is_plain_word_for(draft, part.kind);
}

bool Fitting::is_plain_word_for(const Draft& draft, const std::string& kind) const {
  static const std::set<std::string, std::less<>> plain = {"chair", "stool", "bench", "lamp"};
  const std::string& word = draft.item.category;
  return plain.count(word) > 0 && (kinds_.is_a(kind, word) || kind.ends_with(" " + word));
}

// "table" is as good as a dining table, which people mean by it.
bool Fitting::is_kin(const std::string& category, const std::string& kind) const {
  if (kinds_.is_a(category, kind)) return true;
  const Kind& special = kinds_.get(kind);
  return special.usual && special.parent == category;
}

// Of each draft the share of one such group: all of the anchor's kind want theirs.
std::vector<int> Fitting::shares(const PartCounts& counts, const std::vector<Draft>& drafts,
                                  std::size_t anchor) const {
  int anchors = 0, anchors_here = 0;
  for (const auto& draft : drafts)
    if (is_free(draft) && draft.item.category == drafts[anchor].item.category)
      anchors += draft.item.quantity;
  for (const auto& one : counts)
    if (is_placed_with_anchor(one.mount) && kinds_.is_a(one.kind, counts.front().kind))
      anchors_here += one.count;
  std::vector<int> shares;
  for (const auto& draft : drafts) {
    const bool is_anchor = draft.item.category == drafts[anchor].item.category;
    const int quantity = is_free(draft) ? draft.item.quantity : 0;
    int share = (quantity * anchors_here + anchors - 1) / std::max(1, anchors);
    const bool sits = drafts[anchor].seats > 0 && kinds_.is_a(draft.item.category, "seat");
    if (sits) share = drafts[anchor].seats * std::max(1, anchors_here);
    shares.push_back(is_anchor ? quantity : std::min(quantity, share));
  }
  return shares;
}

std::vector<PartUse> Fitting::uses_of(const PartCounts& counts, const std::vector<Draft>& drafts,
                                             std::size_t anchor, std::vector<int>& left) const {
  left = shares(counts, drafts, anchor);
  std::vector<PartUse> uses = {{0, anchor, 1}};
  --left[anchor];
  for (std::size_t i = 0; i < counts.size(); ++i) {
    int wanted = counts[i].count - (i == 0 ? 1 : 0);
    for (std::size_t d = 0; d < drafts.size() && wanted > 0; ++d) {
      const int some = std::min(wanted, left[d]);
      if (some <= 0 || !belongs(drafts[d], counts[i])) continue;
      if (d != anchor && !is_told_within(drafts[d], counts, drafts, anchor)) continue;
      uses.push_back({i, d, some});
      left[d] -= some;
      wanted -= some;
    }
  }
  return uses;
}

double Fitting::gain_of(const PartCounts& counts, const std::vector<Draft>& drafts,
                         std::size_t anchor) const {
  std::vector<int> got(counts.size(), 0), got_asked = got, left;
  std::set<std::size_t> used;
  for (const auto& use : uses_of(counts, drafts, anchor, left)) {
    got[use.part] += use.quantity;
    if (drafts[use.draft].item.asked) got_asked[use.part] += use.quantity;
    if (use.draft != anchor) used.insert(use.draft);
  }
  double gain = -1.0;  // the anchor itself is no gain
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (!is_placed_with_anchor(counts[i].mount)) {
      gain += of_dressing * got_asked[i];
      continue;
    }
    gain += got[i];
    const int missing = counts[i].count - got[i];
    const bool may_come = counts[i].count == 1 && kinds_.is_a(counts[i].kind, "seat");
    if (missing > 0 && counts[i].spare == 0 && (got[i] == 0 || i == 0) && !may_come) return -1.0;
    if (missing > 0) gain -= got[i] == 0 ? of_missing : of_misfit * missing;
  }
  for (const std::size_t draft : used) gain -= of_misfit * left[draft];
  return gain;
}

Fit Fitting::fit(const Composition& composition, const std::vector<Draft>& drafts,
                            std::size_t anchor) {
  Fit best{&composition, {}, counts_of(composition, {}), 0.0};
  best.gain = best.counts.empty() ? -1.0 : gain_of(best.counts, drafts, anchor);
  for (const auto& parameter : composition.parameters) {
    if (!parameter.choices.empty() || parameter.most - parameter.least > most_values) continue;
    for (double value = parameter.least; value <= parameter.most; value += 1.0) {
      Values values = best.values;
      values[parameter.name] = value;
      const PartCounts& counts = counts_of(composition, values);
      if (counts.empty()) continue;
      const double gain = gain_of(counts, drafts, anchor);
      if (gain > best.gain + 1e-9) best = {&composition, values, counts, gain};
    }
  }
  return best;
}

bool Fitting::is_unit(const Fit& fit, const std::string& category) const {
  int things = 0;
  for (const auto& part : fit.counts)
    if (is_placed_with_anchor(part.mount) && is_kin(category, part.kind)) things += part.count;
  return things == 1;
}

Fit Fitting::best(const std::vector<Draft>& drafts, std::size_t anchor, const FitRequest& request) {
  const std::string& category = drafts[anchor].item.category;
  Fit best;
  for (const auto& [name, one] : *composition::built_in_compositions()) {
    const double ready = readiness(one, request.room, request.wish);
    if (ready <= 0.0) continue;
    const PartCounts& counts = counts_of(one, {});
    if (counts.empty() || !is_kin(category, counts.front().kind)) continue;
    Fit found = fit(one, drafts, anchor);
    if (!request.unit_of.empty() && !is_unit(found, request.unit_of)) continue;
    found.gain *= ready;
    for (const auto& part : found.counts)
      if (part.kind == request.unit_of) found.gain += of_very_kind;
    // Rather the composition for just that.
    if (category != counts.front().kind) found.gain -= of_other_kind;
    if (found.gain > std::max(best.gain, least_gain) + 1e-9) best = std::move(found);
  }
  return best;
}

std::vector<PartUse> Fitting::uses(const Fit& fit, const std::vector<Draft>& drafts, std::size_t anchor) const {
  std::vector<int> left;
  return uses_of(fit.counts, drafts, anchor, left);
}

}  // namespace roomgen::plan
