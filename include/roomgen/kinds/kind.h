#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/geometry/vec.h"
#include "roomgen/kinds/mount.h"
#include "roomgen/kinds/use_zone.h"

namespace roomgen {

/// How far two things stand apart when they serve each other.
struct PreferredGap {
  std::string partner;  ///< category
  double low = 0.0;
  double high = 0.0;    ///< metres between footprints
};

/// The lamp in a kind of thing.
struct Lamp {
  double candela = 60.0;  ///< luminous intensity, the same in all directions within the cone
  double height = 0.8;    ///< of the light in parts of the thing's height; 0: just under the thing
  double cone = 0.0;      ///< degrees from straight down to the edge of its light; 0: all directions
};

/// What is known about a kind of thing. A category inherits what it does not say from its parent
/// ("is": dining chair is chair is seat).
struct Kind {
  std::string name;    ///< "dining chair"
  std::string parent;  ///< may be empty
  std::vector<std::string> synonyms;
  Vec3 size{0.6, 0.6, 0.9};  ///< usual width, depth, height
  Mount mount = Mount::floor;
  double elevation = 0.0;    ///< usual height of the bottom above the floor, for Mount::wall
  bool covers_window = false;  ///< hangs before a window and is made to its measure: a curtain
  Traits traits;
  std::vector<UseZone> zones;  ///< usable when one is free and reachable; none: always usable
  std::vector<PreferredGap> gaps;
  std::vector<std::string> tucks_under;  ///< categories it may slide under (a chair, a table)
  std::optional<Lamp> lamp;              ///< things of this kind shine
  std::vector<std::string> lineage;      ///< itself and its ancestors; empty for an unknown kind
};

/// Is the category the kind of this name, or a descendant of it?
bool is_of(const Kind& category, std::string_view kind);
/// Is the category one of the kinds, or a descendant of one?
bool is_any_of(const Kind& category, const std::vector<std::string>& kinds);

}  // namespace roomgen
