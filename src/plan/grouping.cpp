#include "grouping.h"

#include <algorithm>

#include "block_site.h"
#include "blocks.h"
#include "brief/table_size.h"
#include "composition/plan_groups.h"
#include "gathering.h"
#include "roomgen/base/text.h"

namespace roomgen::plan {

namespace {

constexpr double way_beside = 0.9, way_around = 2.2;  ///< metres of a room beside a group, around a block
constexpr std::size_t many = 24;                      ///< things of a group that one walks around
constexpr double between_groups = 0.7;                ///< metres of floor between them
constexpr double without_composition = 0.8;           ///< what one told thing is worth: a good composition outweighs it

// A thing of a draft, and the rest of it.
Draft split_off(Draft& draft, int quantity, const std::string& group, const std::string& part) {
  Draft taken = draft;
  taken.item.quantity = quantity;
  taken.item.group = group;
  taken.item.part = part;
  draft.item.quantity -= quantity;
  return taken;
}

/// One gathering of a room's drafts into the groups of a plan.
class Gatherer {
 public:
  Gatherer(Fitting& fitting, const KindTable& kinds, const Arrangements& arrangements, std::vector<Draft>& drafts,
           const brief::Brief& brief, Plan& plan)
      : fitting_(fitting),
        kinds_(kinds),
        arrangements_(arrangements),
        drafts_(drafts),
        brief_(brief),
        plan_(plan),
        request_{brief.type, brief::words_of(brief)} {}

  // What is told to stand in rows, a ring or islands; then the groups that gain most; then what usually stands in rows.
  void run() {
    while (const auto told = next([](const Draft& one) { return one.formation && one.item.quantity > 1; }))
      make_told_block(*told);
    constexpr int most_groups = 200;
    for (int n = 0; n < most_groups && make_best_group(); ++n) {
    }
    while (const auto many = next([&](const Draft& one) { return stands_in_rows(one); }))
      make_block(Draft(drafts_[*many]), {}, *many);
    if (plan_.room.polygon.size() < 3) return;  // how large it is depends on these groups
    for (const auto& block : blocks_)
      for (auto& group : plan_.groups)
        if (group.id == block.group) stand_in_room(block, kinds_, plan_.room, drafts_, group);
  }

 private:
  void drop_used_up() {
    std::erase_if(drafts_, [](const Draft& draft) { return draft.item.quantity < 1; });
  }

  template <typename Test>
  std::optional<std::size_t> next(Test is_meant) {
    drop_used_up();
    const auto at = std::find_if(drafts_.begin(), drafts_.end(), [&](const Draft& one) {
      return is_free(one) && one.item.mount == Mount::floor && one.item.size && is_meant(one);
    });
    return at == drafts_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - drafts_.begin()));
  }

  void make_told_block(std::size_t told) {
    const Draft thing = drafts_[told];
    // Who sits in a ring looks at its middle: a lamp at each would turn them off it.
    if (thing.formation->is_round() && kinds_.is_a(thing.item.category, "seat")) return make_block(thing, {}, told);
    FitRequest request = request_;
    request.unit_of = thing.item.category;
    const auto [best, anchor] = best_fit(request, [&](std::size_t i) {
      const bool may_lead = kinds_.is_a(drafts_[i].item.category, "seat");  // the chair of a desk
      return i == told || (may_lead && drafts_[i].item.quantity >= thing.item.quantity);
    });
    make_block(thing, best, best.composition ? anchor : told);
  }

  bool make_best_group() {
    drop_used_up();
    const auto [best, anchor] = best_fit(request_, [&](std::size_t i) { return !is_drawn_up(drafts_[i]); });
    if (best.gain <= 0.0) return false;
    const Draft thing = drafts_[anchor];
    const bool is_told_whole = best.gain <= told_gain(thing);
    const bool are_many = stands_in_rows(thing) || (thing.item.quantity > 1 && thing.item.mount == Mount::wall);
    if (is_told_whole || (are_many && fitting_.is_unit(best, thing.item.category)) || has_more_told(best, anchor))
      make_block(thing, best, anchor);
    else
      make_group(best, anchor);
    return true;
  }

  // Of all anchors that may be one; what the words alone put at a thing counts as well.
  template <typename Test>
  std::pair<Fit, std::size_t> best_fit(const FitRequest& request, Test may_be_anchor) {
    std::pair<Fit, std::size_t> best;
    for (std::size_t i = 0; i < drafts_.size(); ++i) {
      const bool may_stand = drafts_[i].item.mount == Mount::floor || drafts_[i].item.mount == Mount::wall;
      if (!is_free(drafts_[i]) || !may_stand || !may_be_anchor(i)) continue;
      Fit found = fitting_.best(drafts_, i, request);
      if (drafts_[i].item.quantity > 1 && leaves_told_seats(found, i)) found = {};
      if (!found.composition && drafts_[i].item.mount == Mount::wall) continue;
      if (request.unit_of.empty()) found.gain = std::max(found.gain, told_gain(drafts_[i]));
      if (request.unit_of.empty() && backing(drafts_[i])) found.gain += without_composition;
      if (found.gain > best.first.gain + 1e-9) best = {std::move(found), i};
    }
    return best;
  }

  // What the words alone put at each of its things.
  double told_gain(const Draft& thing) const {
    const int count = thing.item.quantity;
    double gain = 0.0;
    for (const std::size_t i : told_companions(thing, count, drafts_, kinds_))
      if (count > 1 || kinds_.is_a(drafts_[i].item.category, "seat")) gain += drafts_[i].item.quantity / count;
    return without_composition * gain;
  }

  // What is told to stand behind a thing, whose user has it at the back: the thing stands before it.
  std::optional<std::size_t> backing(const Draft& thing) const {
    if (thing.item.quantity != 1 || !kinds_.is_any_of(thing.item.category, {"table", "seat"})) return std::nullopt;
    for (std::size_t i = 0; i < drafts_.size(); ++i)
      if (is_free(drafts_[i]) && drafts_[i].item.quantity == 1 && drafts_[i].item.mount == Mount::floor)
        for (const auto& demand : drafts_[i].demands)
          if (demand.said == RelationKind::behind && demand.said_of == thing.mention) return i;
    return std::nullopt;
  }

  // At each of so many; at one seats, and what is told at which side of it: for the rest there is more than one good place.
  std::vector<std::size_t> companions(const Draft& thing) const {
    auto found = told_companions(thing, thing.item.quantity, drafts_, kinds_);
    if (thing.item.quantity == 1)
      std::erase_if(found, [&](std::size_t i) {
        return !kinds_.is_a(drafts_[i].item.category, "seat") &&
               std::any_of(drafts_[i].demands.begin(), drafts_[i].demands.end(),
                           [](const brief::Demand& demand) { return !is_place_at_side(demand.kind); });
      });
    return found;
  }

  // Beyond what the composition takes.
  std::vector<std::size_t> left_told(const Fit& fit, std::size_t anchor) const {
    auto told = companions(drafts_[anchor]);
    const auto uses = fit.composition ? fitting_.uses(fit, drafts_, anchor) : std::vector<PartUse>();
    for (const auto& use : uses) std::erase(told, use.draft);
    return told;
  }
  bool has_more_told(const Fit& fit, std::size_t anchor) const {
    return drafts_[anchor].item.quantity == 1 && (backing(drafts_[anchor]) || !left_told(fit, anchor).empty());
  }
  // Who is told to sit there sits at none of its places.
  bool leaves_told_seats(const Fit& fit, std::size_t anchor) const {
    const auto left = left_told(fit, anchor);
    return std::any_of(left.begin(), left.end(), [&](std::size_t i) { return kinds_.is_a(drafts_[i].item.category, "seat"); });
  }

  // Who is told to be at a table is no middle of another group.
  bool is_drawn_up(const Draft& draft) const {
    return std::any_of(draft.demands.begin(), draft.demands.end(), [&](const brief::Demand& demand) {
      return demand.mention != brief::Demand::none && demand.kind == RelationKind::around &&
             kinds_.is_a(draft.item.category, "seat");
    });
  }

  bool stands_in_rows(const Draft& draft) const {
    const int from = arrangements_.get(kinds_, draft.item.category, draft.item.mount).rows_from;
    return from > 0 && draft.item.quantity >= from && draft.demands.empty();
  }

  // "nothing on the desk", "no cushions", "a bare room".
  bool may_dress(const std::string& kind) const {
    return may_come(kind) && std::none_of(brief_.limits.begin(), brief_.limits.end(), [&](const brief::Limit& limit) {
             if (!limit.category.empty()) return kinds_.is_a(kind, limit.category);
             return limit.mount ? *limit.mount == Mount::surface : limit.on != brief::no_mention;
           });
  }
  // Nothing that is excluded, or beyond the number that was asked for.
  bool may_come(const std::string& kind) const {
    return !brief_.bare && !kinds_.is_any_of(kind, brief_.excluded) &&
           std::none_of(brief_.mentions.begin(), brief_.mentions.end(), [&](const brief::Mention& mention) {
             return mention.counted && kinds_.is_a(kind, mention.category);
           });
  }
  // Dressing; and who works at a desk needs a chair, whoever else sits there.
  bool comes_along(const PartCount& part) const {
    if (!is_placed_with_anchor(part.mount)) return may_dress(part.kind);
    return part.count == 1 && part.spare == 0 && kinds_.is_a(part.kind, "seat") && may_come(part.kind);
  }

  // A plain word becomes what stands there; what is said nowhere of its size, the composition says for so many.
  void mean(Draft& draft, const PartCount& part) const {
    const Vec3 usual = kinds_.get(part.kind).size;
    if (fitting_.is_plain_word_for(draft, part.kind) && !fitting_.is_kin(draft.item.category, part.kind)) {
      if (kinds_.is_a(part.kind, draft.item.category)) draft.item.category = part.kind;
      if (!draft.sized) draft.item.size = usual;
    }
    if (!draft.sized && (part.size - usual).norm() > 1e-6) draft.item.size = part.size;
  }

  std::string id_for(const std::string& name) const {
    const auto number = std::count_if(plan_.groups.begin(), plan_.groups.end(), [&](const PlanGroup& one) {
      return one.id.substr(0, one.id.rfind('-')) == name;
    });
    return name + "-" + std::to_string(number);
  }

  // Gives the things of `copies` such groups to the group, under the names that its parts have behind `path`.
  void take(const Fit& fit, int copies, const std::string& path, std::size_t anchor, PlanGroup& group) {
    std::vector<Draft> taken;
    std::vector<bool> has(fit.counts.size(), false);
    for (const auto& use : fitting_.uses(fit, drafts_, anchor)) {
      const PartCount& part = fit.counts[use.part];
      has[use.part] = true;
      mean(drafts_[use.draft], part);
      const int quantity = std::min(copies * use.quantity, drafts_[use.draft].item.quantity);
      taken.push_back(split_off(drafts_[use.draft], quantity, group.id, path + part.part));
      // Numbers that were asked for stay.
      if (taken.back().item.asked && path.empty())
        for (const auto& parameter : fit.composition->parameters)
          if (parameter.shrinks || fit.values.count(parameter.name) > 0) group.fixed.insert(parameter.name);
    }
    for (std::size_t i = 0; i < fit.counts.size(); ++i)
      if (!has[i] && !comes_along(fit.counts[i])) group.without.insert(path + fit.counts[i].part);
    const auto after = drafts_.begin() + static_cast<std::ptrdiff_t>(anchor) + 1;
    drafts_.insert(after, std::make_move_iterator(taken.begin()), std::make_move_iterator(taken.end()));
  }

  void make_group(const Fit& fit, std::size_t anchor) {
    PlanGroup group;
    group.composition = fit.composition->name;
    group.id = id_for(group.composition);
    group.parameters = fit.values;
    group.asked = drafts_[anchor].item.asked;
    take(fit, 1, "", anchor, group);
    plan_.groups.push_back(std::move(group));
  }

  // A block of a draft's things; each with what a composition of one of them has, whose anchor may be another: the chair
  // of a desk. Or with what the words put there.
  void make_block(const Draft& thing, Fit fit, std::size_t anchor) {
    if (told_gain(thing) >= fit.gain) fit = {};
    const int count = thing.item.quantity, rows = thing.item.mount == Mount::wall ? 1 : 0;
    FormedBlock block{thing.formation.value_or(brief::Formation{.rows = rows}), count, thing};
    block.looks_over = kinds_.is_a(drafts_[anchor].item.category, "table");
    PlanGroup group;
    if (fit.composition) {
      block.composition = fit.composition->name, block.with = fit.values;
      if (count == 1) block.anchor += "/" + fit.counts.front().part;
      if (count == 1 || rows == 1) group.composition = block.composition;
    }
    const char* shape = count == 1 ? "" : block.formation.is_round() ? "ring of " : "rows of ";
    block.group = group.id = id_for(shape + thing.item.category);
    group.asked = thing.item.asked;
    const bool is_counted = block.formation.rows > 0 || block.formation.columns > 0;
    if (is_counted && !block.formation.is_round()) group.fixed.insert("columns");
    take_focus(block);
    if (const auto behind = backing(thing)) take_behind(*behind, block, group);
    take_units(block, fit, anchor, group);
    take_companions(block);
    group.definition = definition_of(block, kinds_, arrangements_);
    if (count > 1) leave_looking(block);
    plan_.groups.push_back(std::move(group));
    blocks_.push_back(std::move(block));
  }

  void take_focus(FormedBlock& block) {
    if (!block.formation.is_round()) return;
    for (const std::size_t i : foci_of(block.thing, drafts_, kinds_)) {
      if (!drafts_[i].demands.empty() || drafts_[i].item.mount != Mount::floor || block.has_focus) continue;
      block.has_focus = true, block.focus_kind = drafts_[i].item.category;
      drafts_[i].item.group = block.group, drafts_[i].item.part = block_focus;
    }
  }

  // Where the thing shall look, looks the front of what is behind it.
  void take_behind(std::size_t behind, FormedBlock& block, PlanGroup& group) {
    Draft& draft = drafts_[behind];
    draft.item.group = block.group, draft.item.part = block_behind;
    block.behind = draft.item.category;
    group.composition.clear();
    for (auto& one : drafts_)
      if (one.mention == block.thing.mention && is_free(one) && block.looks_over)
        std::erase_if(one.demands, [&](const brief::Demand& demand) {
          return demand.kind == RelationKind::face_same_as && demand.mention == draft.mention;
        });
    for (const auto& demand : block.thing.demands) {
      if (!is_looking_at(demand.kind) || demand.mention != brief::Demand::none) continue;
      draft.demands.push_back(demand);
      draft.demands.back().kind = RelationKind::face_to, draft.demands.back().is_means = true;
    }
  }

  void take_units(const FormedBlock& block, const Fit& fit, std::size_t anchor, PlanGroup& group) {
    const int places = places_of(block), each = block.count / places;
    for (int place = 0; place < places; ++place) {
      const std::string path = unit_name(place);
      if (fit.composition) {
        take(fit, each, path + "/", anchor, group);
        continue;
      }
      const auto own = std::find_if(drafts_.begin(), drafts_.end(), [&](const Draft& one) {
        return is_free(one) && one.mention == block.thing.mention && one.item.category == block.thing.item.category;
      });
      const Draft taken = split_off(*own, each, group.id, path);
      drafts_.insert(own + 1, taken);
    }
  }

  void take_companions(FormedBlock& block) {
    if (places_of(block) > 1) return;
    for (const std::size_t i : companions(block.thing)) {
      drafts_[i].item.group = block.group, drafts_[i].item.part = "at" + std::to_string(block.companions.size());
      block.companions.push_back(drafts_[i]);
      Draft& companion = block.companions.back();
      companion.item.quantity /= block.count;
      if (is_drawn_up(companion)) suit(block, companion.item.quantity);
    }
  }

  // Large enough for those who sit there, unless its size is said.
  void suit(FormedBlock& block, int seats) {
    const auto& category = block.thing.item.category;
    if (block.thing.sized || !block.thing.item.size || !kinds_.is_a(category, "table")) return;
    const Vec3 size = brief::table_for(*block.thing.item.size, kinds_.get(category).traits.round, seats);
    block.thing.item.size = size;
    for (auto& draft : drafts_)
      if (draft.item.group == block.group && draft.item.part == block_unit) draft.item.size = size;
  }

  // As a whole it looks there: only who sits in the middle does so straight.
  void leave_looking(const FormedBlock& block) {
    for (auto& draft : drafts_)
      if (draft.item.group == block.group && draft.mention == block.thing.mention)
        std::erase_if(draft.demands, [&](const brief::Demand& one) {
          return is_looking_at(one.kind) || (block.has_focus && one.kind == RelationKind::around);
        });
  }

  Fitting& fitting_;
  const KindTable& kinds_;
  const Arrangements& arrangements_;
  std::vector<Draft>& drafts_;
  const brief::Brief& brief_;
  Plan& plan_;
  FitRequest request_;
  std::vector<FormedBlock> blocks_;
};

}  // namespace

Grouping::Grouping(const KindTable& kinds, const Arrangements& arrangements)
    : kinds_(kinds), arrangements_(arrangements), fitting_(kinds) {}

Grouping::Floor Grouping::floor_of(std::vector<Draft> drafts, const brief::Brief& brief) {
  Plan plan;
  run(drafts, brief, plan);
  Floor floor;
  double focus = 0.0;  // metres that what is looked at reaches into the room
  for (const auto& draft : drafts) {
    const PlanItem& item = draft.item;
    if (item.group.empty()) floor.area += floor_area(item, kinds_);
    const bool is_focus = item.group.empty() && item.mount == Mount::floor && item.size &&
                          kinds_.is_any_of(item.category, usual_foci());
    if (is_focus) focus = std::max(focus, item.size->y());
    plan.items.push_back(item);
  }
  composition::complete_groups(plan, kinds_);
  for (const auto& group : plan.groups) {
    const auto ways = composition::ways_to_stand(plan, group, kinds_, {});
    if (!ways) continue;
    const Vec2 box = composition::box_of(ways->front(), kinds_).size();
    floor.area += (box.array() + between_groups).prod();
    const bool is_block = !group.definition.empty() || ways->front().members.size() >= many;
    Vec2 with_way = box.array() + (is_block ? way_around : way_beside);
    if (is_block) with_way.y() += focus;
    if (with_way.prod() > floor.largest.prod()) floor.largest = with_way;
  }
  return floor;
}

void Grouping::run(std::vector<Draft>& drafts, const brief::Brief& brief, Plan& plan) {
  plan.groups.clear();
  for (auto& draft : drafts) draft.item.group.clear(), draft.item.part.clear();
  gather(drafts, brief, plan);
}

void Grouping::gather(std::vector<Draft>& drafts, const brief::Brief& brief, Plan& plan) {
  if (composition::built_in_compositions()) Gatherer(fitting_, kinds_, arrangements_, drafts, brief, plan).run();
}

}  // namespace roomgen::plan
