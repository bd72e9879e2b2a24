#pragma once

#include "propose.h"
#include "roomgen/solve/place.h"

namespace roomgen {

/// The constraints' verdicts and the general terms for one pose, not yet ranked.
PlacementTerms score(const ProposalContext& context, const Footprint& footprint, double bottom);

/// The terms as one number: what decides between candidates that the fusion ranks alike.
double total_degree(const PlacementTerms& terms);

/// For candidates that are only tested for feasibility: how many constraints the pose loses.
int count_lost(const ProposalContext& context, const Footprint& footprint, double bottom);

}  // namespace roomgen
