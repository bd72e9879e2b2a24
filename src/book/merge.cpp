#include "merge.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "composition/plan_groups.h"
#include "part_count.h"

namespace roomgen::book {

namespace {

using brief::Demand;
using plan::Draft;

// The mentions of demands and drafts by other numbers, so that those of the wish come first.
void renumber(std::vector<Draft>& drafts, std::size_t first) {
  for (std::size_t i = 0; i < drafts.size(); ++i) {
    drafts[i].mention = first + i;
    for (auto& demand : drafts[i].demands)
      if (demand.mention != Demand::none) demand.mention += first;
  }
}

/// The merging of one design and one wish.
class Merging {
 public:
  Merging(design::PlanParts parts, const brief::Brief& brief, const KindTable& kinds)
      : brief_(brief),
        kinds_(kinds),
        drafts_(std::move(parts.drafts)),
        groups_(std::move(parts.groups)),
        asked_(plan::asked_items(brief, kinds)),
        taken_(brief.mentions.size(), false) {
    complete();
    renumber(drafts_, brief.mentions.size());
    matched_.assign(drafts_.size(), false);
  }

  Merged run() {
    if (brief_.bare) drafts_.clear(), groups_.clear();
    drop([&](const Draft& draft) { return is_forbidden(draft); });
    for (const bool exactly : {true, false})
      for (std::size_t m = 0; m < brief_.mentions.size(); ++m)
        if (!brief_.mentions[m].contradicts && !taken_[m]) match(m, exactly);
    drop([&](const Draft& draft) { return is_beyond(draft); });
    for (auto& draft : asked_) {
      const int missing = lacking(draft);
      if (missing <= 0) continue;
      draft.item.quantity = missing;
      drafts_.push_back(std::move(draft));
    }
    return {std::move(drafts_), std::move(groups_)};
  }

 private:
  // What compositions bring along gets drafts, and all of a part is so many.
  void complete() {
    Plan plan;
    for (const auto& draft : drafts_) plan.items.push_back(draft.item);
    plan.groups = groups_;
    composition::complete_groups(plan, kinds_);
    for (std::size_t i = 0; i < plan.items.size(); ++i) {
      if (i >= drafts_.size()) drafts_.emplace_back();
      drafts_[i].item = plan.items[i];
    }
    groups_ = std::move(plan.groups);
  }

  bool is_forbidden(const Draft& draft) const {
    const auto& category = draft.item.category;
    return kinds_.is_any_of(category, brief_.excluded) ||
           std::any_of(brief_.limits.begin(), brief_.limits.end(), [&](const brief::Limit& limit) {
             if (!limit.category.empty())
               return false;  // "no other chairs": those of the wish stay
             return limit.mount
                        ? draft.item.mount == *limit.mount
                        : limit.on != brief::no_mention && draft.item.mount == Mount::surface;
           });
  }

  // More than the wish wants of what it counts.
  bool is_beyond(const Draft& draft) const {
    if (draft.item.asked) return false;
    const auto& category = draft.item.category;
    const bool covers_window = kinds_.get(category).covers_window;
    return std::any_of(brief_.mentions.begin(), brief_.mentions.end(),
                       [&](const brief::Mention& mention) {
                         if (covers_window && kinds_.get(mention.category).covers_window)
                           return true;
                         return mention.counted && !mention.at_least && mention.owner.empty() &&
                                !mention.contradicts && kinds_.is_a(category, mention.category);
                       }) ||
           std::any_of(brief_.limits.begin(), brief_.limits.end(), [&](const brief::Limit& limit) {
             return !limit.category.empty() && kinds_.is_a(category, limit.category);
           });
  }

  // Takes drafts out of their groups and of the design, with what stands on them.
  template <typename Test>
  void drop(Test is_out) {
    std::set<std::size_t> gone;
    for (const auto& draft : drafts_)
      if (is_out(draft)) gone.insert(draft.mention);
    for (bool changed = !gone.empty(); changed;) {
      changed = false;
      for (const auto& draft : drafts_)
        if (!draft.item.asked && depends_on(draft, gone))
          changed |= gone.insert(draft.mention).second;
    }
    for (const auto& draft : drafts_)
      if (gone.count(draft.mention)) leave_group(draft);
    std::erase_if(drafts_, [&](const Draft& draft) { return gone.count(draft.mention) > 0; });
    matched_.resize(drafts_.size());
    std::erase_if(groups_, [&](const PlanGroup& group) {
      return std::none_of(drafts_.begin(), drafts_.end(),
                          [&](const Draft& draft) { return draft.item.group == group.id; });
    });
  }

  bool depends_on(const Draft& draft, const std::set<std::size_t>& gone) const {
    const bool is_on_gone =
        std::any_of(draft.demands.begin(), draft.demands.end(), [&](const Demand& demand) {
          return demand.kind == RelationKind::on && gone.count(demand.mention) > 0;
        });
    if (is_on_gone || draft.item.group.empty()) return is_on_gone;
    // Without its anchor a group is none.
    return std::any_of(drafts_.begin(), drafts_.end(), [&](const Draft& other) {
      return gone.count(other.mention) > 0 && other.item.group == draft.item.group &&
             is_anchor(other);
    });
  }

  bool is_anchor(const Draft& draft) const {
    const PlanGroup* group = group_of(draft);
    return group && group->anchor == draft.item.part;
  }
  const PlanGroup* group_of(const Draft& draft) const {
    for (const auto& group : groups_)
      if (group.id == draft.item.group) return &group;
    return nullptr;
  }
  void leave_group(const Draft& draft) {
    for (auto& group : groups_)
      if (group.id == draft.item.group) group.without.insert(draft.item.part);
  }

  // 3: of the very kind; 2: a sort of what is wished for; 1: what is wished for is a sort of it; 0:
  // another thing.
  int likeness(const Draft& draft, const brief::Mention& mention) const {
    const auto& category = draft.item.category;
    if (category == mention.category) return 3;
    if (kinds_.is_a(category, mention.category)) return 2;
    return kinds_.is_a(mention.category, category) ? 1 : 0;
  }

  // Of the design's things those that the mention may mean, the likeliest first.
  std::vector<std::size_t> meant_by(const brief::Mention& mention, bool exactly) const {
    const int least = exactly ? 3 : 1;
    std::vector<std::size_t> fitting;
    for (std::size_t i = 0; i < drafts_.size(); ++i)
      if (!matched_[i] && likeness(drafts_[i], mention) >= least && may_be(drafts_[i], mention))
        fitting.push_back(i);
    std::stable_sort(fitting.begin(), fitting.end(), [&](std::size_t a, std::size_t b) {
      return rank(drafts_[a], mention) > rank(drafts_[b], mention);
    });
    return fitting;
  }

  void match(std::size_t m, bool exactly) {
    const brief::Mention& mention = brief_.mentions[m];
    const auto fitting = meant_by(mention, exactly);
    if (fitting.empty()) return;
    taken_[m] = true;
    const std::string category = drafts_[fitting.front()].item.category;
    int open = mention.counted ? mention.quantity : 0;
    const bool is_one = !mention.counted && !mention.open;
    for (const std::size_t i : fitting) {
      if (drafts_[i].item.category != category) continue;
      take(i, m, mention.counted ? open : is_one ? 1 : 0);
      open -= drafts_[i].item.quantity;
      if (is_one || (mention.counted && open <= 0)) break;
    }
  }

  bool may_be(const Draft& draft, const brief::Mention& mention) const {
    return draft.item.mount == mention.mount || mention.mount_heard == brief::HeardWords::none;
  }

  double rank(const Draft& draft, const brief::Mention& mention) const {
    const double same_number =
        mention.counted && draft.item.quantity == mention.quantity ? 2.0 : 0.0;
    const double leads = is_anchor(draft) ? 1.0 : 0.0;
    return 10.0 * likeness(draft, mention) + same_number + leads - 0.1 * draft.item.spare;
  }

  // `number`: at most so many of them are the wish's; 0: all.
  void take(std::size_t i, std::size_t m, int number) {
    const brief::Mention& mention = brief_.mentions[m];
    if (number > 0 && drafts_[i].item.quantity != number) set_number(i, number);
    Draft& draft = drafts_[i];
    if (number > 0 && draft.item.quantity > number) {
      Draft rest = draft;
      rest.item.quantity -= number;
      draft.item.quantity = number;
      rest.mention = brief_.mentions.size() + drafts_.size();
      drafts_.push_back(std::move(rest));
      matched_.push_back(false);
    }
    matched_[i] = true;
    become(drafts_[i], m, mention);
  }

  // As many as the wish wants, where the group can be set so.
  void set_number(std::size_t i, int number) {
    PlanItem& item = drafts_[i].item;
    if (item.group.empty()) {
      if (item.quantity < number && item.location) return;
      item.quantity = number;
      return;
    }
    for (auto& group : groups_) {
      if (group.id != item.group) continue;
      std::vector<PlanItem> items;
      for (const auto& draft : drafts_)
        if (draft.item.group == group.id) items.push_back(draft.item);
      const auto counts = set_part_count(group, items, item.part, number, kinds_);
      for (auto& draft : drafts_)
        if (const auto count = counts.find(draft.item.part);
            draft.item.group == group.id && count != counts.end())
          draft.item.quantity = count->second;
    }
  }

  void become(Draft& draft, std::size_t m, const brief::Mention& mention) {
    for (auto& other : drafts_)
      for (auto& demand : other.demands)
        if (demand.mention == draft.mention) demand.mention = m;
    const auto own = std::find_if(asked_.begin(), asked_.end(),
                                  [&](const Draft& one) { return one.mention == m; });
    if (own == asked_.end()) return;
    PlanItem& item = draft.item;
    draft.mention = m;
    draft.part_of = own->part_of;
    draft.sized = own->sized;
    draft.formation = own->formation;
    item.asked = true;
    item.spare = 0;
    if (likeness(draft, mention) == 1)
      item.category = own->item.category, item.size = own->item.size;
    if (!mention.looks.empty()) item.description = own->item.description;
    if (own->sized) item.size = own->item.size;
    if (own->item.height) item.height = own->item.height;
    item.varied = item.varied || own->item.varied;
    for (const auto& demand : own->demands) add_demand(draft, demand);
  }

  // A relation to something outside takes the thing out of its group, but moves a whole group with
  // its anchor.
  void add_demand(Draft& draft, const Demand& demand) {
    draft.demands.push_back(demand);
    if (demand.mention != Demand::none && is_in_group(demand.mention, draft.item.group)) return;
    if (demand.kind == RelationKind::edge && draft.item.location) return;
    if (draft.item.group.empty() || is_anchor(draft) || draft.item.mount == Mount::surface) return;
    if (demand.mention != Demand::none && demand.kind == RelationKind::near) return;
    leave_group(draft);
    draft.item.group.clear(), draft.item.part.clear();
  }
  bool is_in_group(std::size_t mention, const std::string& group) const {
    return !group.empty() && std::any_of(drafts_.begin(), drafts_.end(), [&](const Draft& draft) {
      return draft.mention == mention && draft.item.group == group;
    });
  }

  // Things of a wish that are not there yet.
  int lacking(const Draft& asked) const {
    int there = 0;
    for (const auto& draft : drafts_)
      if (draft.mention == asked.mention) there += draft.item.quantity;
    const brief::Mention& mention = brief_.mentions[asked.mention];
    return there > 0 && !mention.counted ? 0 : asked.item.quantity - there;
  }

  const brief::Brief& brief_;
  const KindTable& kinds_;
  std::vector<Draft> drafts_;
  std::vector<PlanGroup> groups_;
  std::vector<Draft> asked_;  ///< what the wish asks for, as if there were no design
  std::vector<bool> taken_, matched_;
};

}  // namespace

Merged merge(design::PlanParts parts, const brief::Brief& brief, const KindTable& kinds) {
  return Merging(std::move(parts), brief, kinds).run();
}

}  // namespace roomgen::book
