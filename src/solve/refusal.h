#pragma once

#include "layout.h"
#include "roomgen/base/result.h"
#include "roomgen/scene/problem.h"

namespace roomgen {

/// Why an object found no place among so many candidates, of which so many passed the cheap tests; for
/// people and for a model that shall answer again.
Error refusal(Layout& layout, const PlacementTask& task, const Layout::Candidate& candidate,
              int candidates, int feasible);

/// What keeps a thing, with what comes along, from its suggested place: "; in the way at the
/// suggested place: bed-0"; empty if nothing is found.
std::string why_not_there(Layout& layout, const PlacementTask& task);

/// What a verdict on an object says, by name: "desk-0 could not be used, for it stands before it".
std::string misfit(const Layout& layout, const Object& object, const Layout::Verdict& verdict);

/// The ways in which a thing may have been meant to be turned: as was suggested, else along any wall.
std::vector<double> meant_yaws(const Layout& layout, const std::optional<double>& suggested);

/// The ids of what is in the way of an object where it stands as it says.
std::vector<std::string> in_the_way(const Layout& layout, const Object& standing);

/// Must somebody be able to come to it on the floor?
bool needs_way_in(const Layout& layout, const PlacementTask& task);

/// Why a thing of which that is true has no place where Layout::has_way_in() is not.
Error no_way_in(const PlacementTask& task);

}  // namespace roomgen
