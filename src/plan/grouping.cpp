#include "grouping.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "block_site.h"
#include "blocks.h"
#include "composition/plan_groups.h"
#include "gathering.h"
#include "roomgen/base/text.h"

namespace roomgen::plan {

namespace {

using composition::Composition;
using composition::Values;

// What a group is worth: things that stand in their place, against parts that nobody has and things
// that are left over.
constexpr double of_missing = 0.15, of_misfit = 0.6, of_other_kind = 0.3, of_very_kind = 1.0, least_gain = 0.5;
constexpr int most_values = 40;
constexpr double way_beside = 0.9, way_around = 1.8;  ///< metres of a room beside a group, around a block
constexpr double between_groups = 0.7;                ///< metres of floor between them

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

Grouping::Grouping(const KindTable& kinds, const Arrangements& arrangements)
    : kinds_(kinds), arrangements_(arrangements) {}

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
      counts.push_back({member.part, member.category, member.mount, 1, member.spare, member.size});
  }
  return at->second;
}

// Told to be at this anchor, or at something that the group has as well; and near others, which is little.
bool Grouping::is_told_within(const Draft& draft, const Counts& counts, const std::vector<Draft>& drafts,
                              std::size_t anchor) const {
  const auto is_within = [&](const brief::Demand& demand) {
    if (demand.mention == brief::Demand::none) return false;
    return demand.mention == drafts[anchor].mention ||
           std::any_of(drafts.begin(), drafts.end(), [&](const Draft& other) {
             return other.mention == demand.mention && is_free(other) &&
                    std::any_of(counts.begin(), counts.end(), [&](const PartCount& part) {
                      return part.mount == Mount::floor && is_kin(other.item.category, part.kind);
                    });
           });
  };
  bool is_tied = draft.demands.empty(), is_tied_elsewhere = false;
  for (const auto& demand : draft.demands) {
    const bool within = is_given_by_pattern(demand.kind) && is_within(demand);
    is_tied = is_tied || within;
    is_tied_elsewhere = is_tied_elsewhere || (!within && demand.kind != RelationKind::near);
  }
  return is_tied && !is_tied_elsewhere;
}

bool Grouping::belongs(const Draft& draft, const PartCount& part) const {
  if (!is_free(draft) || draft.item.mount != part.mount) return false;
  // A plain word is meant as what stands there: "stools" at a bar.
  return is_kin(draft.item.category, part.kind) || is_plain_word_for(draft, part.kind);
}

bool Grouping::is_plain_word_for(const Draft& draft, const std::string& kind) const {
  static const std::set<std::string, std::less<>> plain = {"chair", "stool", "table", "lamp"};
  return plain.count(draft.item.category) > 0 && kinds_.is_a(kind, draft.item.category);
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
    int share = (quantity * anchors_here + anchors - 1) / std::max(1, anchors);
    const bool sits = drafts[anchor].seats > 0 && kinds_.is_a(draft.item.category, "seat");
    if (sits) share = drafts[anchor].seats * std::max(1, anchors_here);
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
      if (some <= 0 || !belongs(drafts[d], counts[i])) continue;
      if (d != anchor && !is_told_within(drafts[d], counts, drafts, anchor)) continue;
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
    const bool may_come = counts[i].count == 1 && kinds_.is_a(counts[i].kind, "seat");
    if (missing > 0 && counts[i].spare == 0 && (got[i] == 0 || i == 0) && !may_come) return -1.0;
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

std::string Grouping::id_for(const std::string& name, const Plan& plan) {
  const auto number = std::count_if(plan.groups.begin(), plan.groups.end(), [&](const PlanGroup& one) {
    return one.id.starts_with(name + "-") && one.id.find_first_not_of("0123456789", name.size() + 1) == std::string::npos;
  });
  return name + "-" + std::to_string(number);
}

// Who works at a desk needs a chair, whoever else sits there.
bool Grouping::may_come_along(const std::string& kind, const brief::Brief& brief) const {
  return kinds_.is_a(kind, "seat") && !brief.bare && !kinds_.is_any_of(kind, brief.excluded);
}

// A plain word becomes what stands there; what is said nowhere of its size, the composition says for so many.
void Grouping::mean(Draft& draft, const PartCount& part) const {
  const Vec3 usual = kinds_.get(part.kind).size;
  if (is_plain_word_for(draft, part.kind) && !is_kin(draft.item.category, part.kind)) {
    draft.item.category = part.kind;
    if (!draft.sized) draft.item.size = usual;
  }
  if (!draft.sized && (part.size - usual).norm() > 1e-6) draft.item.size = part.size;
}

// Gives the things of `copies` such groups to the group, under the names that its parts have behind `path`.
void Grouping::take(const Fit& fit, int copies, const std::string& path, std::vector<Draft>& drafts,
                    std::size_t anchor, const brief::Brief& brief, PlanGroup& group) {
  std::vector<Draft> taken;
  std::vector<bool> has(fit.counts.size(), false);
  std::vector<int> left;
  for (const auto& use : uses_of(fit.counts, drafts, anchor, left)) {
    has[use.part] = true;
    mean(drafts[use.draft], fit.counts[use.part]);
    const int quantity = std::min(copies * use.quantity, drafts[use.draft].item.quantity);
    taken.push_back(split_off(drafts[use.draft], quantity, group.id, path + fit.counts[use.part].part));
    // Numbers that were asked for stay.
    if (taken.back().item.asked && path.empty())
      for (const auto& parameter : fit.composition->parameters) group.fixed.insert(parameter.name);
  }
  for (std::size_t i = 0; i < fit.counts.size(); ++i) {
    const PartCount& part = fit.counts[i];
    const bool is_dressing = !is_placed_with_anchor(part.mount) && may_dress(part.kind, brief);
    const bool comes_along = is_dressing || (part.count == 1 && part.spare == 0 && may_come_along(part.kind, brief));
    if (!has[i] && !comes_along) group.without.insert(path + part.part);
  }
  const auto after = drafts.begin() + static_cast<std::ptrdiff_t>(anchor) + 1;
  drafts.insert(after, std::make_move_iterator(taken.begin()),
                std::make_move_iterator(taken.end()));
}

void Grouping::make_group(const Fit& fit, std::vector<Draft>& drafts, std::size_t anchor,
                          const brief::Brief& brief, Plan& plan) {
  PlanGroup group;
  group.composition = fit.composition->name;
  group.id = id_for(group.composition, plan);
  group.parameters = fit.values;
  group.asked = drafts[anchor].item.asked;
  take(fit, 1, "", drafts, anchor, brief, group);
  plan.groups.push_back(std::move(group));
}

// Whether it is one thing with what belongs to it, of which a block may have many.
bool Grouping::is_unit(const Fit& fit, const std::string& category) const {
  int things = 0;
  for (const auto& part : fit.counts)
    if (part.mount == Mount::floor && is_kin(category, part.kind)) things += part.count;
  return things == 1;
}

// What the words alone put at each of its things.
double Grouping::told_gain(const Draft& thing, const std::vector<Draft>& drafts) const {
  constexpr double without_composition = 0.8;  // which a good composition outweighs
  const int count = thing.item.quantity;
  double gain = 0.0;
  for (const std::size_t i : told_companions(thing, count, drafts))
    if (count > 1 || kinds_.is_a(drafts[i].item.category, "seat")) gain += drafts[i].item.quantity / count;
  return without_composition * gain;
}

// Who is told to be at a table is no middle of another group.
bool Grouping::is_drawn_up(const Draft& draft) const {
  return std::any_of(draft.demands.begin(), draft.demands.end(), [&](const brief::Demand& demand) {
    return demand.mention != brief::Demand::none && demand.kind == RelationKind::around &&
           kinds_.is_a(draft.item.category, "seat");
  });
}

bool Grouping::stands_in_rows(const Draft& draft) const {
  const int from = arrangements_.get(kinds_, draft.item.category, draft.item.mount).rows_from;
  return from > 0 && draft.item.quantity >= from && draft.demands.empty();
}

// A block of a draft's things; each with what a composition of one of them has, whose anchor may be another: the chair
// of a desk.
void Grouping::make_block(const Draft& thing, Fit fit, std::vector<Draft>& drafts, std::size_t anchor,
                          const brief::Brief& brief, Plan& plan, std::vector<FormedBlock>& blocks) {
  const int count = thing.item.quantity;
  if (told_gain(thing, drafts) >= fit.gain) fit = {};
  const int rows = count == 1 ? 1 : 0;
  FormedBlock block{thing.formation.value_or(brief::Formation{.rows = rows, .columns = rows}), count, thing};
  block.looks_over = kinds_.is_a(drafts[anchor].item.category, "table");
  if (fit.composition) block.composition = fit.composition->name, block.with = fit.values;
  PlanGroup group;
  const char* shape = count == 1 ? "" : block.formation.is_round() ? "ring of " : "rows of ";
  group.id = id_for(shape + thing.item.category, plan);
  group.asked = block.thing.item.asked;
  const bool is_counted = block.formation.rows > 0 || block.formation.columns > 0;
  if (is_counted && !block.formation.is_round()) group.fixed.insert("columns");
  block.group = group.id;
  if (block.formation.is_round())
    for (const std::size_t i : foci_of(thing, drafts, kinds_)) {
      if (!drafts[i].demands.empty() || drafts[i].item.mount != Mount::floor || block.has_focus) continue;
      block.has_focus = true, block.focus_kind = drafts[i].item.category;
      drafts[i].item.group = group.id, drafts[i].item.part = block_focus;
    }
  const int places = places_of(block), each = count / places;
  for (int place = 0; place < places; ++place) {
    const std::string path = unit_name(place);
    if (fit.composition) {
      take(fit, each, path + "/", drafts, anchor, brief, group);
      continue;
    }
    const auto own = std::find_if(drafts.begin(), drafts.end(), [&](const Draft& one) {
      return is_free(one) && one.mention == thing.mention && one.item.category == thing.item.category;
    });
    const Draft taken = split_off(*own, each, group.id, path);
    drafts.insert(own + 1, taken);
  }
  for (const std::size_t i : told_companions(thing, count, drafts)) {
    if (places > 1) break;
    drafts[i].item.group = group.id, drafts[i].item.part = "at" + std::to_string(block.companions.size());
    block.companions.push_back(drafts[i]);
    block.companions.back().item.quantity /= count;
  }
  group.definition = definition_of(block, kinds_, arrangements_);
  for (auto& draft : drafts)
    if (draft.item.group == group.id && draft.mention == thing.mention && count > 1)
      std::erase_if(draft.demands, [&](const brief::Demand& one) {
        return is_looking_at(one.kind) || (block.has_focus && one.kind == RelationKind::around);
      });
  plan.groups.push_back(std::move(group));
  blocks.push_back(std::move(block));
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
    const Vec2 box = composition::box_of(ways->front(), kinds_).size();
    floor.area += (box.array() + between_groups).prod();
    const Vec2 with_way = box.array() + (group.definition.empty() ? way_beside : way_around);
    if (with_way.prod() > floor.largest.prod()) floor.largest = with_way;
  }
  return floor;
}

Grouping::Fit Grouping::best_fit(const std::vector<Draft>& drafts, std::size_t anchor, const std::string& room,
                                 const std::string& wish, const std::string& unit_of) {
  const std::string& category = drafts[anchor].item.category;
  Fit best;
  for (const auto& [name, one] : *composition::built_in_compositions()) {
    const Counts& counts = counts_of(one, {});
    if (counts.empty() || !is_kin(category, counts.front().kind)) continue;
    const double ready = readiness(one, room, wish);
    if (ready <= 0.0) continue;
    Fit found = fit(one, drafts, anchor);
    if (!unit_of.empty() && !is_unit(found, unit_of)) continue;
    found.gain *= ready;
    for (const auto& part : found.counts)
      if (part.kind == unit_of) found.gain += of_very_kind;
    // Rather the composition for just that.
    if (category != counts.front().kind) found.gain -= of_other_kind;
    if (found.gain > std::max(best.gain, least_gain) + 1e-9) best = std::move(found);
  }
  return best;
}

void Grouping::make_told_block(std::vector<Draft>& drafts, std::size_t told, const std::string& wish,
                               const brief::Brief& brief, Plan& plan, std::vector<FormedBlock>& blocks) {
  const Draft thing = drafts[told];
  Fit best;
  std::size_t anchor = told;
  for (std::size_t i = 0; i < drafts.size(); ++i) {
    if (!is_free(drafts[i]) || drafts[i].item.mount != Mount::floor) continue;
    if (i != told && drafts[i].item.quantity < thing.item.quantity) continue;
    Fit found = best_fit(drafts, i, brief.type, wish, thing.item.category);
    if (found.gain > best.gain + 1e-9) best = std::move(found), anchor = i;
  }
  make_block(thing, best, drafts, anchor, brief, plan, blocks);
}

void Grouping::run(std::vector<Draft>& drafts, const brief::Brief& brief, Plan& plan) {
  constexpr int most_groups = 200;
  plan.groups.clear();
  for (auto& draft : drafts) draft.item.group.clear(), draft.item.part.clear();
  if (!composition::built_in_compositions()) return;
  const std::string wish = lower(plan.prompt);
  std::vector<FormedBlock> blocks;
  const auto next_block = [&](const auto& is_meant) {
    std::erase_if(drafts, [](const Draft& draft) { return draft.item.quantity < 1; });
    const auto at = std::find_if(drafts.begin(), drafts.end(), [&](const Draft& one) {
      return is_free(one) && one.item.mount == Mount::floor && one.item.quantity > 1 && one.item.size && is_meant(one);
    });
    return at == drafts.end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - drafts.begin()));
  };
  const auto is_told = [](const Draft& one) { return one.formation.has_value(); };
  while (const auto told = next_block(is_told)) make_told_block(drafts, *told, wish, brief, plan, blocks);
  for (int n = 0; n < most_groups; ++n) {
    Fit best;
    std::size_t anchor = 0;
    for (std::size_t i = 0; i < drafts.size(); ++i) {
      if (!is_free(drafts[i]) || drafts[i].item.mount != Mount::floor || is_drawn_up(drafts[i])) continue;
      Fit found = best_fit(drafts, i, brief.type, wish, "");
      found.gain = std::max(found.gain, told_gain(drafts[i], drafts));
      if (found.gain > best.gain + 1e-9) best = std::move(found), anchor = i;
    }
    if (best.gain <= 0.0) break;
    const Draft thing = drafts[anchor];
    const bool is_told_whole = best.gain <= told_gain(thing, drafts);
    if (is_told_whole || (stands_in_rows(thing) && is_unit(best, thing.item.category)))
      make_block(thing, best, drafts, anchor, brief, plan, blocks);
    else
      make_group(best, drafts, anchor, brief, plan);
    std::erase_if(drafts, [](const Draft& draft) { return draft.item.quantity < 1; });
  }
  while (const auto many = next_block([&](const Draft& one) { return stands_in_rows(one); }))
    make_block(Draft(drafts[*many]), {}, drafts, *many, brief, plan, blocks);
  if (plan.room.polygon.size() < 3) return;  // how large it is depends on these groups
  for (const auto& block : blocks)
    for (auto& group : plan.groups)
      if (group.id == block.group) stand_in_room(block, kinds_, plan.room, drafts, group);
}

}  // namespace roomgen::plan
