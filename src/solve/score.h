#pragma once

#include <optional>

#include "place.h"
#include "propose.h"

namespace roomgen {

/// The constraints' verdicts and the general terms for one pose, not yet ranked.
PlacementTerms score(const ProposalContext& context, const Footprint& footprint, double bottom);
/// The two halves of score(): the verdicts, and the dearer general terms.
/// Nothing once more than `most_lost` constraints are lost.
std::optional<PlacementTerms> score_relations(const ProposalContext& context,
                                              const Footprint& footprint, double bottom,
                                              int most_lost);
void add_general_terms(const ProposalContext& context, const Footprint& footprint, double bottom,
                       PlacementTerms& terms);

/// The terms as one number: what decides between candidates that the fusion ranks alike.
double total_degree(const PlacementTerms& terms, const Weights& weights);

/// Which constraints are looked at: those with the room alone, those with a target, or both.
enum class Asked { all, room, things };

/// Do all of these constraints hold at the pose?
bool holds_all(const ProposalContext& context, const Footprint& footprint, double bottom,
               Asked asked = Asked::all);

}  // namespace roomgen
