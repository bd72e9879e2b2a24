#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/relation.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

enum class Fault { outside, overlap, blocks_door, blocks_window, unusable, doors_apart, no_access, too_crowded };
std::string_view name(Fault fault);

/// Something that docs/constraints.md ("Valid") forbids. After 200 overlaps of a room, or 10,000 pairs of things
/// whose boxes overlap, overlaps are looked for no further: too_crowded names the thing at which that was.
struct Violation {
  Fault fault = Fault::outside;
  std::string object;  ///< id, or empty for the room
  std::string other;   ///< the second object, the opening, the room that nobody can enter
};
/// "overlap: box-2 and box-1"
std::string to_text(const Violation& violation);

/// What can be said about a scene without knowing what was wished for.
struct SceneReport {
  std::vector<Violation> violations;
  std::vector<RelationVerdict> relations;

  int relations_held() const;
};

/// Examines a whole scene, a dwelling room by room: people come through its doors, and each room
/// must have one that leads outdoors by way of others. `models` decides solids whose boxes overlap; objects without a model count as
/// boxes.
SceneReport examine(const Scene& scene, const ModelTable& models, const KindTable& categories);

}  // namespace roomgen
