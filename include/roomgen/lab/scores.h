#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/scene/scene.h"

namespace roomgen::lab {

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

/// One requirement with its verdict.
struct JudgedRequirement {
  std::string text;  ///< as the annotator wrote it: "eq,1,on,0,table,lamp"
  bool satisfied = false;
  std::string reason;   ///< "2 in the scene", "no lamp"
  std::string missing;  ///< the category for want of which it fails; may be empty
  std::vector<std::string> unjudged;  ///< attributes that nothing known of a thing could tell
};

/// How a scene meets the requirements of its description, measure by measure, after SceneEval
/// (docs/evaluation.md).
struct RoomScore {
  std::string id, difficulty;
  std::size_t objects = 0, solids = 0;  ///< solids: all but rugs
  std::vector<JudgedRequirement> counts, attributes, object_relations, room_relations;
  std::vector<std::pair<std::string, std::string>>
      collisions;                             ///< ids of objects whose meshes cross
  std::vector<std::string> colliding;         ///< ids, rugs included, as SceneEval counts
  std::vector<std::string> colliding_solids;  ///< in collision with another solid
  std::vector<std::string> outside;
  std::vector<std::string> unsupported;  ///< ids: held by nothing, or out of balance
  double navigability = 0.0;  ///< the share of the free floor that hangs together
  std::size_t doors = 0, clear_doors = 0;      ///< passages are doors
  std::size_t windows = 0, clear_windows = 0;  ///< clear: nothing stands before it
  std::map<std::string, std::vector<std::string>>
      in_the_way;                                           ///< what stands before an opening; ids
  std::map<std::string, std::vector<std::string>> matched;  ///< category to ids
  std::vector<RoomScore> rooms;  ///< of a dwelling: each by itself, without verdicts, by its id
};

/// A dwelling counts as a whole: its description speaks of all its rooms. What is asked of the walls
/// is asked of those of a thing's own room; collisions and all that needs no description are found
/// room by room and added up.
RoomScore score_room(const Requirements& requirements, const Scene& scene,
                     const ModelTable& models);

/// A row whose room could not be scored.
struct Unscored {
  std::string id, reason;
};

/// Totals over all rooms and by difficulty, then each room with every verdict.
Json score_json(std::span<const RoomScore> scores, std::span<const Unscored> unscored = {});

/// A table of the measures, then for each room what fails and why.
std::string score_markdown(std::span<const RoomScore> scores,
                           std::span<const Unscored> unscored = {});

}  // namespace roomgen::lab
