#include "score.h"

#include <algorithm>
#include <cmath>
#include <limits>


namespace roomgen {

namespace {

// A slot of this width looks like an oversight: too wide to touch, too narrow to walk through.
constexpr double slot_low = 0.03;
constexpr double slot_high = 0.45;
// Between groups people walk.
constexpr double way_between_groups = 0.9;
constexpr double door_comfort = 0.6;
constexpr double location_comfort = 1.0;

double walkway_degree(const ProposalContext& context, const Footprint& footprint) {
  double degree = 1.0;
  for (const auto& area : context.layout.door_areas())
    if (footprint.bounds().overlaps(area.bounds(), door_comfort))
      degree = std::min(degree, std::min(gap(footprint, area) / door_comfort, 1.0));
  return degree;
}

double spread_degree(const ProposalContext& context, const Footprint& footprint) {
  double degree = 1.0;
  const Bounds2& box = footprint.bounds();
  const double wide = context.whole ? way_between_groups : slot_high;
  for (const auto& other : context.layout.things()) {
    if (!box.overlaps(other.footprint.bounds(), wide) || other.object->traits.flat ||
        other.object->id == context.task.object.id)
      continue;
    const double slot = gap(footprint, other.footprint);
    if (slot > slot_low && slot < wide) degree -= 0.3;
  }
  return std::max(degree, 0.0);
}

Footprint with_companions(const ProposalContext& context, const Footprint& own) {
  if (!context.whole) return own;
  const Bounds2& box = *context.whole;
  return Footprint(own.to_world(0.5 * (box.low + box.high)), box.size(), own.yaw());
}

// Those that stand around the same target keep their distance from each other: 1 when this one has
// its share of the target's circumference to itself.
double evenness_degree(const ProposalContext& context, const Footprint& footprint) {
  double degree = 1.0;
  for (const auto& company : context.companies)
    for (const auto& other : company.positions)
      degree = std::min(degree, (other - footprint.center()).norm() / company.share);
  return degree;
}

double closeness_degree(const ProposalContext& context, const Footprint& footprint) {
  const Suggestion& wanted = context.suggestion;
  double degree = 0.0;
  if (wanted.location)
    degree = 1.0 - std::min((footprint.center() - *wanted.location).norm() / location_comfort, 1.0);
  if (wanted.facing) degree += context.layout.weights().facing * std::cos(footprint.yaw() - *wanted.facing);
  return degree;
}

double metres_off(const ProposalContext& context, const Footprint& footprint) {
  const Suggestion& wanted = context.suggestion;
  if (!wanted.binds) return 0.0;
  double off = wanted.location ? (footprint.center() - *wanted.location).norm() : 0.0;
  if (wanted.facing)
    off += context.layout.weights().metres_a_radian *
           turn_between(context.task.object, footprint.yaw(), *wanted.facing);
  return off;
}

// What nobody has put anywhere gathers in the middle of what carries it.
double degree_of(const ProposalContext& context, const ResolvedRelation& relation,
                 const Judgement& judgement, const Footprint& footprint) {
  if (relation.kind != RelationKind::on || !judgement.held || context.suggestion.binds)
    return judgement.degree;
  const double apart = (relation.targets.front().center() - footprint.center()).norm();
  return std::clamp(1.0 - apart, 0.0, 1.0);
}

}  // namespace

bool holds_all(const ProposalContext& context, const Footprint& footprint, double bottom,
               Asked asked) {
  const Subject subject{footprint, bottom, bottom + context.task.object.size.z()};
  return std::all_of(
      context.relations.begin(), context.relations.end(), [&](const ResolvedRelation& relation) {
        const Asked needs = takes_target(relation.kind) ? Asked::things : Asked::room;
        return (asked != Asked::all && asked != needs) ||
               judge(relation, subject, context.layout.room()).held;
      });
}

std::optional<PlacementTerms> score_relations(const ProposalContext& context,
                                              const Footprint& footprint, double bottom,
                                              int most_lost) {
  PlacementTerms terms;
  const Subject subject{footprint, bottom, bottom + context.task.object.size.z()};
  for (const auto& relation : context.relations) {
    const Judgement judgement = judge(relation, subject, context.layout.room());
    ++(judgement.held ? terms.held : terms.lost);
    if (terms.lost > most_lost) return std::nullopt;
    terms.relations += degree_of(context, relation, judgement, footprint);
  }
  if (!context.relations.empty()) terms.relations /= static_cast<double>(context.relations.size());
  return terms;
}

void add_general_terms(const ProposalContext& context, const Footprint& footprint, double bottom,
                       PlacementTerms& terms) {
  terms.rest = context.rest ? context.rest->degree(footprint, bottom) : 1.0;
  terms.walkway = walkway_degree(context, footprint);
  // Between small things on a table no one walks.
  const bool on_surface = context.task.object.mount == Mount::surface;
  terms.spread = on_surface ? 1.0 : spread_degree(context, with_companions(context, footprint));
  terms.evenness = evenness_degree(context, footprint);
  terms.closeness = closeness_degree(context, footprint);
  terms.off = metres_off(context, footprint);
  if (context.surroundings)
    terms.arrangement += preference(*context.surroundings, footprint, bottom);
}

PlacementTerms score(const ProposalContext& context, const Footprint& footprint, double bottom) {
  PlacementTerms terms =
      *score_relations(context, footprint, bottom, std::numeric_limits<int>::max());
  add_general_terms(context, footprint, bottom, terms);
  return terms;
}

double total_degree(const PlacementTerms& terms, const Weights& weights) {
  return weights.relations * terms.relations + weights.rest * terms.rest +
         weights.walkway * terms.walkway + weights.spread * terms.spread +
         weights.evenness * terms.evenness + weights.closeness * terms.closeness -
         weights.off * terms.off + terms.arrangement;
}

}  // namespace roomgen
