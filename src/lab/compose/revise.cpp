#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "meet.h"
#include "roomgen/base/text.h"
#include "roomgen/lab/compose.h"

namespace roomgen::lab {

namespace {

// A revision changes the floor by at most these factors of its area, a thing's sides by this one, scores by that one.
constexpr double greatest_growth = 1.6, least_growth = 0.6, usual_growth = 1.2, smaller = 0.85, weaker = 0.4;
constexpr double least_side = 1.2, greatest_side = 50.0;
constexpr double more_of_each = 3.0;

const MeasureVerdict* missed(const ErrorReport& report, std::string_view name) {
  const auto found = std::ranges::find_if(report.measures, [&](const auto& measure) {
    return measure.name == name && measure.missed > 1e-9;
  });
  return found == report.measures.end() ? nullptr : &*found;
}

bool is_optional(const ProgramTerm& term) {
  return term.op == ProgramOp::within && term.literals.front() == 0.0 && term.operands.front().op == ProgramOp::count;
}

/// One try at a revision of a copy.
class Reviser {
 public:
  Reviser(const WrittenProgram& before, const ErrorReport& report) : report_(report), written_(before) {}

  // What somebody counted by name.
  bool counts_are_missed() const {
    return std::ranges::any_of(report_.unmet, [&](const auto& verdict) { return set_named(verdict.name) != nullptr; });
  }
  bool only_asked_is_missed() const {
    return counts_are_missed() &&
           std::ranges::none_of(report_.measures, [](const auto& measure) { return measure.missed > 1e-9; });
  }

  // The floor that would make what stands there cover what is asked for.
  bool fit_floor() {
    const auto* occupancy = missed(report_, "occupancy");
    if (!occupancy || !written_.is_room_free || report_.occupancy <= 0.0) return false;
    if (counts_are_missed()) return false;
    const double wanted = compose::middle_share(occupancy->asked);
    return resize(std::clamp(report_.occupancy / wanted, least_growth, greatest_growth),
                  "the room's floor made to suit what stands on it");
  }

  bool grow_room() { return counts_are_missed() && written_.is_room_free && resize(usual_growth, "a larger room"); }

  // Nobody asked for these.
  bool drop_optional() {
    const auto* occupancy = missed(report_, "occupancy");
    if (occupancy ? report_.occupancy < occupancy->asked.low : !counts_are_missed()) return false;
    std::vector<std::string> dropped;
    for (auto& [name, term] : written_.program.constraints)
      if (is_optional(term) && term.literals.back() > 0.0 && !serves_measure(name)) {
        term.literals.back() = 0.0;
        dropped.push_back(name);
      }
    return say(!dropped.empty(), "without what nobody asked for: " + join(dropped, ", "));
  }

  bool permit_more() {
    if (only_asked_is_missed()) return false;
    bool changed = false;
    for (auto& [name, term] : written_.program.constraints)
      if (is_optional(term) && helps(name)) term.literals.back() += more_of_each, changed = true;
    return say(changed, "more of what may be added");
  }

  // What has no room along the walls may stand freely, and that of which nothing found a place, anywhere.
  bool leave_usual_places() {
    std::vector<std::string> freed;
    for (auto& [name, members] : written_.program.sets) {
      const bool is_missed = std::ranges::find(report_.unmet, name, &ConstraintVerdict::name) != report_.unmet.end();
      if (!is_missed) continue;
      const auto wall = [](const SetRelation& relation) { return relation.relation.ends_with("against_wall"); };
      const std::size_t before = members.relations.size();
      std::erase_if(members.relations, wall);
      // The first says what carries it.
      if (!report_.counts.contains(members.factory) && members.relations.size() > 1) members.relations.resize(1);
      if (members.relations.size() < before) freed.push_back(name);
    }
    return say(!freed.empty(), "away from where such things usually stand: " + join(freed, ", "));
  }

  bool smaller_things() {
    if (!counts_are_missed()) return false;
    for (auto& wish : written_.stock) wish.size = Vec3(wish.size->cwiseProduct(Vec3(smaller, smaller, 1.0)));
    return say(!written_.stock.empty(), "smaller things");
  }

  bool weaken_scores() {
    bool changed = false;
    for (auto& [name, term] : written_.program.scores) changed |= weaken(term);
    return say(changed, "scores that count less");
  }

  Revision take(const WrittenProgram& before) {
    Json patch = Json::diff(to_json(before.program), to_json(written_.program));
    return {std::move(written_), std::move(reason_), std::move(patch), 0};
  }

 private:
  bool say(bool changed, std::string reason) {
    if (changed) reason_ = std::move(reason);
    return changed;
  }

  const ProgramSet* set_named(const std::string& name) const {
    const auto found = std::ranges::find(written_.program.sets, name, &NamedSets::value_type::first);
    return found == written_.program.sets.end() ? nullptr : &found->second;
  }

  const Kind* kind_of(const std::string& set) const {
    const ProgramSet* members = set_named(set);
    return members ? KindTable::built_in().find(members->factory) : nullptr;
  }
  static bool seats_people(const Kind& kind) {
    return seats_on(ProgramVocabulary::built_in(), kind, kind.size.x()) > 0;
  }
  static bool has_shelves(const Kind& kind) { return has_tag(ProgramVocabulary::built_in(), kind, "shelf"); }

  // Is there less of a measure than was asked for?
  bool lacks(std::string_view measure) const {
    const auto* verdict = missed(report_, measure);
    return verdict && verdict->reached < verdict->asked.low;
  }

  // Would more of a set bring what is missed?
  bool helps(const std::string& name) const {
    const Kind* kind = kind_of(name);
    if (!kind) return false;
    const bool on_floor = std::ranges::any_of(set_named(name)->relations, [](const auto& relation) {
      return relation.relation == "on_floor";
    });
    return lacks("objects") || (lacks("occupancy") && on_floor && !kind->traits.flat) ||
           (lacks("seats") && seats_people(*kind)) || (lacks("shelves") && has_shelves(*kind));
  }

  // Seats may be what is asked for even where nobody counted chairs.
  bool serves_measure(const std::string& set) const {
    if (lacks("objects")) return true;
    const Kind* kind = kind_of(set);
    return kind && ((written_.asked.seats && seats_people(*kind)) || (written_.asked.shelves && has_shelves(*kind)));
  }

  bool resize(double growth, std::string reason) {
    Room& room = written_.plan.room;
    const double factor = std::sqrt(growth);
    const Vec2 sides = factor * bounds(room.polygon).size();
    if (sides.minCoeff() < least_side || sides.maxCoeff() > greatest_side) return false;
    for (auto& point : room.polygon.points) point = (point * factor * 100.0).array().round().matrix() / 100.0;
    for (auto& opening : room.openings) shift(opening, factor);
    if (!check(room)) return false;
    written_.program.room.polygon = room.polygon;
    written_.program.room.openings = room.openings;
    return say(true, std::move(reason));
  }

  // Its middle keeps its share of the wall, it keeps its width.
  static void shift(Opening& opening, double factor) {
    const double by = std::round(0.5 * (opening.from + opening.to) * (factor - 1.0) * 100.0) / 100.0;
    opening.from += by, opening.to += by;
  }

  static bool weaken(ProgramTerm& term) {
    bool changed = false;
    if (term.op == ProgramOp::minimize || term.op == ProgramOp::maximize) term.number *= weaker, changed = true;
    for (auto& operand : term.operands) changed |= weaken(operand);
    return changed;
  }

  const ErrorReport& report_;
  WrittenProgram written_;
  std::string reason_;
};

}  // namespace

std::optional<Revision> revise(const WrittenProgram& written, const ErrorReport& report, int last_rule) {
  using Rule = bool (Reviser::*)();
  static constexpr Rule rules[] = {&Reviser::fit_floor,     &Reviser::leave_usual_places, &Reviser::grow_room,
                                   &Reviser::drop_optional, &Reviser::permit_more, &Reviser::smaller_things,
                                   &Reviser::weaken_scores};
  constexpr int count = static_cast<int>(std::size(rules));
  if (report.is_met()) return std::nullopt;
  for (int k = 0; k < count; ++k) {
    const int rule = (last_rule + k) % count;
    Reviser reviser(written, report);
    if (!(reviser.*rules[rule])()) continue;
    Revision revision = reviser.take(written);
    revision.rule = rule + 1;
    return revision;
  }
  return std::nullopt;
}

}  // namespace roomgen::lab
