#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "evaluate/attributes.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/requirement.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// Says whether a thing has an attribute.
using AttributeJudge =
    std::function<AttributeVerdict(const Object& object, const std::string& attribute)>;

/// How large a thing is made, as a share of its mesh's own size.
using SizeShare = std::function<double(const Object& object)>;

/// The share below which a thing is not what was asked for any more.
inline constexpr double least_size_share = 0.6;

/// Checks every clause on the finished scene. Counts are of all things of the category (those of
/// kinds that are one count too), exactly unless `at_least`, and of none that was made smaller than
/// `least_size_share`. An attribute must be had by all its things; that of "floor", "walls", "ceiling" or "accent wall" must be the room's material. A relation
/// (docs/constraints.md) must hold for each of the things towards one of the targets. What is asked of
/// the room is measured on it. A reason says what is missing.
std::vector<RequirementVerdict> check_requirements(std::span<const Requirement> requirements,
                                                   const Scene& scene,
                                                   const KindTable& categories,
                                                   const AttributeJudge& has_attribute,
                                                   const SizeShare& size_share = {});

}  // namespace roomgen
