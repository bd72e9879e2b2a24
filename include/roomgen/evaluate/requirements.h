#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"

namespace roomgen {

/// How many are wanted: "eq,2", "ge,3".
struct Wanted {
  enum class Comparison { eq, lt, gt, le, ge };
  Comparison comparison = Comparison::eq;
  int quantity = 0;

  bool holds(int count) const;
};

/// One thing that a description asks for, as SceneEval's annotators write it. `text` is what stood
/// in the file.
struct CountRequirement {
  std::string text;
  Wanted wanted;
  std::string category;  ///< "coffee_table"
};
struct AttributeRequirement {
  std::string text;
  Wanted wanted;
  std::string category;
  std::vector<std::string> attributes;  ///< "matte_black"
};
/// Things in a relation to one of them, the anchor: `on`, anchor 0 of {table, lamp} is a lamp on a
/// table.
struct ObjectRelationRequirement {
  std::string text;
  Wanted wanted;
  std::string relation;
  int anchor = 0;                   ///< index into things; -1 when the annotator names none
  std::vector<std::string> things;  ///< categories, a repeated one for several of it
};
struct RoomRelationRequirement {
  std::string text;
  Wanted wanted;
  std::string relation;
  std::string thing;               ///< category
  std::vector<std::string> parts;  ///< "wall", "door", "room"
};

/// What one description asks for: a row of SceneEval's annotations.
struct Requirements {
  std::string id, description, difficulty;
  std::vector<CountRequirement> counts;
  std::vector<AttributeRequirement> attributes;
  std::vector<ObjectRelationRequirement> object_relations;
  std::vector<RoomRelationRequirement> room_relations;

  /// All categories that it names, those of the counts first, each once.
  std::vector<std::string> categories() const;
};

/// Rows of a CSV file with a head line that names at least ID, Description and ObjCount; ObjAttr,
/// OORel, OARel and Difficulty may be there, other columns are ignored. Fields may be quoted. A
/// comparison that carries its quantity ("eq1" for "eq,1") is understood. Errors name line, column
/// and requirement.
Result<std::vector<Requirements>> parse_requirements(std::string_view text,
                                                     const std::string& source);

}  // namespace roomgen
