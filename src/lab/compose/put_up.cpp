#include "put_up.h"

#include <algorithm>

namespace roomgen::lab::compose {

namespace {

using namespace programs;

constexpr std::size_t most_relations = 3;  // of the language
// Metres, as docs/constraints.md has them; what is good, not what is barely so.
constexpr double near_most = 1.5, near_good = 0.5, next_most = 0.5, next_good = 0.3, far_least = 1.5;
constexpr double strong = 5.0, weak = 1.0;

bool has(const std::vector<Relation>& relations, RelationKind kind) {
  return std::ranges::any_of(relations, [&](const Relation& relation) { return relation.kind == kind; });
}

ProgramTerm hinge(ProgramTerm value, double low, double high) {
  ProgramTerm result = term(ProgramOp::hinge, {}, {std::move(value)});
  result.literals = {low, high};
  return result;
}

ProgramTerm at_most(ProgramTerm value, double most) {
  return term(ProgramOp::at_most, {}, {std::move(value), number(most)});
}
ProgramTerm at_least(ProgramTerm value, double least) {
  return term(ProgramOp::at_least, {}, {std::move(value), number(least)});
}

/// Reads the relations of one subject.
class HabitReader {
 public:
  HabitReader(const std::vector<Relation>& relations, const Subject& subject, const FindTarget& target, bool asked)
      : relations_(relations), subject_(subject), find_(target), asked_(asked) {}

  Habits read() {
    for (const auto& relation : relations_) take(relation);
    return std::move(habits_);
  }

 private:
  bool is_seat() const { return is_of(subject_.kind, "seat"); }

  // Sets that are described by each other would be none.
  bool may_be_put(const TargetSet& target) const { return target.kind && target.comes_before; }

  void put(std::string name, ProgramSet target) {
    const auto same = [&](const SetRelation& relation) { return relation.relation == name; };
    if (habits_.relations.size() < most_relations && std::ranges::none_of(habits_.relations, same))
      habits_.relations.push_back({false, std::move(name), {std::move(target)}});
  }

  void score(double weight, ProgramTerm value) { habits_.scores.push_back(minimize(weight, std::move(value))); }

  // Of each by itself: the nearest of many would speak for all.
  void keep_within(const ProgramSet& target, double good, double most) {
    const auto way = distance(variable("v"), target);
    if (asked_) habits_.truths.push_back(for_all("v", set(subject_.set), at_most(way, most)));
    score(weak, mean("v", set(subject_.set), hinge(way, 0.0, good)));
  }

  void near(const TargetSet& target) {
    if (subject_.kind.traits.flat && target.kind && is_of(*target.kind, "table")) return lie_under(target);
    keep_within(target.set, near_good, near_most);
  }

  // As little of it as can be beside the rug, and the rug as it is turned.
  void lie_under(const TargetSet& target) {
    const ProgramSet rugs = set(subject_.set);
    score(strong, term(ProgramOp::subtract, {},
                       {term(ProgramOp::footprint, {either({target.set, rugs})}), term(ProgramOp::footprint, {rugs})}));
    score(weak, term(ProgramOp::angle, {rugs, target.set}));
  }

  void look_at(const ProgramSet& target) { score(strong, term(ProgramOp::focus, {set(subject_.set), target})); }

  void take(const Relation& relation) {
    switch (relation.kind) {
      case RelationKind::edge: return against_wall(false);
      case RelationKind::corner: return against_wall(true);
      case RelationKind::middle:
        if (subject_.is_single) score(weak, term(ProgramOp::center, {set(subject_.set)}));
        return;
      default: break;
    }
    if (const auto target = find_(relation.target)) return take(relation, *target);
    if (asked_) habits_.unsaid.push_back(to_text(relation));
  }

  void against_wall(bool corner) {
    if (subject_.mount != Mount::floor) return;
    put("against_wall", room());
    if (corner) put("side_against_wall", room());
  }

  void take(const Relation& relation, const TargetSet& target) {
    switch (relation.kind) {
      case RelationKind::on:
      case RelationKind::inside:
        if (subject_.mount == Mount::surface && may_be_put(target)) put("on", target.set);
        return;
      case RelationKind::around: return around(target);
      case RelationKind::side_of: return beside(target);
      case RelationKind::near: return near(target);
      case RelationKind::next_to: return keep_within(target.set, next_good, next_most);
      case RelationKind::under: return keep_within(target.set, 0.0, near_most);
      case RelationKind::face_to: return look_at(target.set);
      case RelationKind::in_front_of: return in_front(target);
      case RelationKind::face_same_as:
      case RelationKind::aligned: return score(weak, term(ProgramOp::angle, {set(subject_.set), target.set}));
      case RelationKind::face_opposite_to: return face_opposite(target);
      case RelationKind::far: return keep_away(target);
      case RelationKind::center_aligned: return;  // goes with what else is said
      default:
        if (asked_) habits_.unsaid.push_back(to_text(relation));
    }
  }

  void around(const TargetSet& target) {
    if (is_seat() && may_be_put(target)) return put("front_against", target.set);
    keep_within(target.set, near_good, near_most);
    look_at(target.set);
  }

  // What stands at a thing's side and looks the way it does.
  void beside(const TargetSet& target) {
    if (asked_ && may_be_put(target) && has(relations_, RelationKind::face_same_as))
      return put("leftright_leftright", target.set);
    keep_within(target.set, near_good, near_most);
  }

  void in_front(const TargetSet& target) {
    if (is_seat() && may_be_put(target) && is_of(*target.kind, "table")) return put("front_against", target.set);
    look_at(target.set);
    keep_within(target.set, near_good, near_most);
  }

  void face_opposite(const TargetSet& target) {
    look_at(target.set);
    if (target.kind) score(strong, term(ProgramOp::focus, {target.set, set(subject_.set)}));
  }

  void keep_away(const TargetSet& target) {
    const auto way = distance(set(subject_.set), target.set);
    if (asked_) habits_.truths.push_back(at_least(way, far_least));
    score(weak, hinge(way, far_least, 100.0));
  }

  const std::vector<Relation>& relations_;
  const Subject& subject_;
  const FindTarget& find_;
  bool asked_;
  Habits habits_;
};

}  // namespace

SetRelation carried_by(Mount mount, const ProgramSet& carrier) {
  switch (mount) {
    case Mount::wall: return {false, "flush_wall", {room()}};
    case Mount::ceiling: return {false, "hanging", {room()}};
    case Mount::surface: return {false, "on", {carrier}};
    default: return {false, "on_floor", {room()}};
  }
}

Habits habits_of(const std::vector<Relation>& relations, const Subject& subject, const FindTarget& target, bool asked) {
  return HabitReader(relations, subject, target, asked).read();
}

}  // namespace roomgen::lab::compose
