#pragma once

#include <map>
#include <string>
#include <vector>

#include "roomgen/evaluate/requirements.h"
#include "roomgen/scene/model_table.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// One requirement with its verdict.
struct Verdict {
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
  std::vector<Verdict> counts, attributes, object_relations, room_relations;
  std::vector<std::pair<std::string, std::string>> collisions;  ///< ids of objects whose meshes cross
  std::vector<std::string> colliding;         ///< ids, rugs included, as SceneEval counts
  std::vector<std::string> colliding_solids;  ///< in collision with another solid
  std::vector<std::string> outside;
  std::vector<std::string> unsupported;  ///< ids: held by nothing, or out of balance
  double navigability = 0.0;  ///< the share of the free floor that hangs together
  std::size_t doors = 0, clear_doors = 0;      ///< passages are doors
  std::size_t windows = 0, clear_windows = 0;  ///< clear: nothing stands before it
  std::map<std::string, std::vector<std::string>> in_the_way;  ///< what stands before an opening; ids
  std::map<std::string, std::vector<std::string>> matched;  ///< category to ids
  std::vector<RoomScore> rooms;  ///< of a dwelling: each by itself, without verdicts, by its id
};

/// A dwelling counts as a whole: its description speaks of all its rooms. What is asked of the walls
/// is asked of those of a thing's own room; collisions and all that needs no description are found
/// room by room and added up.
RoomScore score_room(const Requirements& requirements, const Scene& scene,
                     const ModelTable& models);

}  // namespace roomgen
