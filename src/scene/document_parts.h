#pragma once

#include "base/json_reader.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

// Parts of the documents of scenes and plans. What is wrong with them is reported to the reader.

/// "tilt": two angles in degrees, both 0 if there is none.
Vec2 read_tilt(const JsonReader& json);
Json tilt_json(const Vec2& tilt);
/// "asset"; empty if there is none.
AssetRef read_asset(const JsonReader& json);
/// One that files may use; nothing, and reported, if it is none.
std::optional<RelationKind> read_relation(const JsonReader& json);
/// "room".
Room read_room(const JsonReader& json);
Requirement read_requirement(const JsonReader& json);
RequirementVerdict read_verdict(const JsonReader& json);
/// "constraints", "location" and "facing": what is said of where a thing or a group goes.
struct SaidPlace {
  std::vector<Relation> relations;
  std::optional<Vec2> location;
  std::optional<double> facing;  ///< radians
};
SaidPlace read_said_place(const JsonReader& json);
/// "heard".
std::vector<Heard> read_heard(const JsonReader& json);

}  // namespace roomgen
