#pragma once

#include <map>
#include <string>
#include <vector>

#include "roomgen/evaluate/requirements.h"
#include "roomgen/evaluate/score.h"
#include "roomgen/evaluate/thing.h"

namespace roomgen {

/// What relations are judged on: the things of a scene and which of them are of which category.
struct MatchedThings {
  const Room& room;
  const RoomThings& parts;
  const std::vector<Thing>& things;
  const std::map<std::string, std::vector<std::size_t>>& matched;

  const std::vector<std::size_t>& of(const std::string& category) const { return matched.at(category); }
};

Verdict judge_relation(const ObjectRelationRequirement& relation, const MatchedThings& scene);
Verdict judge_relation(const RoomRelationRequirement& relation, const MatchedThings& scene);

}  // namespace roomgen
