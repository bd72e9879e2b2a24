#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "roomgen/design/designer.h"

namespace roomgen::design {

/// Those still to come that the answer about request.object places too: what stands on the same thing;
/// with ModelSteps::groups also all that stands on the floor, or all that hangs. What comes with its group is not among them.
/// `answered` have their answers already.
std::vector<PlannedObject> answered_together(const PlaceRequest& request, ModelSteps steps,
                                             const std::set<std::string>& answered);

/// What an answer puts onto one thing and gives no place stands in a row along it, in the answer's order: the
/// places by id. `answers`: all of one answer.
std::map<std::string, Vec2> places_in_rows(
    const std::vector<std::pair<std::string, PlaceAdvice>>& answers, const Scene& scene);

/// What a thing of the plan brings along, and how much floor they take about it; empty unless it is the
/// anchor of a group.
std::string group_text(const Plan& plan, const PlannedObject& planned);

/// "desk-1: a low oak desk, about 1.4 x 0.7 x 0.75 m"
std::string line_of(const Plan& plan, const PlannedObject& planned);

}  // namespace roomgen::design
