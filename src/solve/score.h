#pragma once

#include "propose.h"
#include "roomgen/solve/place.h"

namespace roomgen {

/// The constraints' verdicts and the general terms for one pose, not yet ranked.
PlacementTerms score(const ProposalContext& context, const Footprint& footprint, double bottom);

/// The terms as one number: what decides between candidates that the fusion ranks alike.
double total_degree(const PlacementTerms& terms);

/// Do all constraints hold at the pose?
bool holds_all(const ProposalContext& context, const Footprint& footprint, double bottom);

}  // namespace roomgen
