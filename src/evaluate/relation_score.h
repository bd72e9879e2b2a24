#pragma once

#include <map>
#include <string>
#include <vector>

#include "roomgen/evaluate/score.h"
#include "thing.h"

namespace roomgen {

/// A room with the surfaces of its walls, doors and windows.
struct RoomSurfaces {
  explicit RoomSurfaces(const Room& of) : room(of), parts(room_things(of)) {}
  Room room;
  RoomThings parts;
};

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

}  // namespace roomgen
