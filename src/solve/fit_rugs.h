#pragma once

#include <span>
#include <string>
#include <vector>

#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/scene.h"
#include "roomgen/scene/object.h"
#include "roomgen/scene/room.h"

namespace roomgen {

/// A rug and what may become of it.
struct RugWish {
  std::string id;
  bool asked = false;      ///< it stays whatever happens
  bool size_told = false;  ///< somebody said how large it is
  int wishes = 0;          ///< so many of its relations, the first ones, were asked for
  bool place_told = false;  ///< and where: it stays so if it can
};

/// What became of the rugs.
struct RugFit {
  std::vector<std::string> left_out;  ///< nobody had asked for them
  std::vector<std::string> uneven;    ///< something stands partly on them still
};

/// How a thing stands to a rug: all of it that comes down to the floor is on the rug, or nothing is.
enum class RugStand { beside, on, partly };
/// What is lower than this, metres above the floor, meets the rug.
double low_over(const Object& rug);
RugStand stand_to_rug(const Object& thing, const Object& rug, const ModelTable& models);

/// How high a rug lies: on what it lies over of these, or on the floor.
double height_of_rug(const Object& rug, std::span<const Object> objects);
/// Lays those of the rugs that lie over larger ones on top of them.
void pile_rugs(std::span<Object> objects);

/// Ends a furnished room: cuts and moves the rugs, as little as can be, so that all that stands on the floor
/// is on a rug with all its feet or with none; lifts what is on one to its top, with all that it carries;
/// takes rugs out that cannot lie so. Rugs that are locked stay as they are, and what is partly on one stays
/// on the floor. The objects are those of one room, standing on its floor as if rugs had no height.
RugFit fit_rugs(const Room& room, std::vector<Object>& objects, const ModelTable& models,
                const KindTable& kinds, std::span<const RugWish> wishes);

}  // namespace roomgen
