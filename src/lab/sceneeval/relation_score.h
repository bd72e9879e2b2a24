#pragma once

#include <map>
#include <string>
#include <vector>

#include "relation_functions.h"
#include "roomgen/lab/scores.h"

namespace roomgen::lab {

/// What relations are judged on: the things of a scene, each in its room, and which of them are of
/// which category.
struct MatchedThings {
  const std::vector<Thing>& things;
  const std::vector<const RoomSurfaces*>& around;  ///< of each thing
  const std::map<std::string, std::vector<std::size_t>>& matched;

  const std::vector<std::size_t>& of(const std::string& category) const { return matched.at(category); }
};

JudgedRequirement judge_relation(const ObjectRelationRequirement& relation, const MatchedThings& scene);
JudgedRequirement judge_relation(const RoomRelationRequirement& relation, const MatchedThings& scene);

}  // namespace roomgen::lab
