#pragma once

#include <vector>

#include "propose.h"

namespace roomgen {

// The groups of poses that propose_exact() puts together, each appended to `poses`.

/// Flush to the walls: in steps, at both ends, beside openings and neighbours, opposite targets.
void propose_at_walls(const ProposalContext& context, std::vector<Pose>& poses);
/// What each relation with a thing makes worth trying.
void propose_for_relations(const ProposalContext& context, std::vector<Pose>& poses);
/// Where the suggestion says, and as near as makes no difference.
void propose_suggested(const ProposalContext& context, std::vector<Pose>& poses);
/// For a thing with companions: where the box around all of them means something.
void propose_with_companions(const ProposalContext& context, std::vector<Pose>& poses);
/// Wherever it can rest on the support, and of what means something the places where it can.
void propose_on_surface(const ProposalContext& context, const Object& support,
                        std::vector<Pose>& poses);

/// Small things side by side stand so far apart, metres.
inline constexpr double apart_on_surface = 0.006;

Vec2 size_of(const ProposalContext& context);
/// Of the bottom: what hangs above a thing clears its top as far as the room allows.
double mounting_height(const ProposalContext& context);
/// Half extents of a thing turned by `relative_yaw` against the target's axes.
Vec2 turned_half(const Vec2& size, double relative_yaw);
/// Offsets from a suggested place: itself, and what still follows it where it is taken.
std::vector<Vec2> offsets_about_suggestion(double reach);
/// The turns that a designer's word means at a place: the one that was said, else those that the
/// constraints and the walls suggest.
std::vector<double> suggested_yaws(const ProposalContext& context, const Vec2& at,
                                   std::vector<double> usual);

}  // namespace roomgen
