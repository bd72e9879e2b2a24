#pragma once

#include <map>
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
  std::string partner;  ///< a kind
  double low = 0.0;
  double high = 0.0;    ///< metres between footprints
};

/// The lamp in a kind of thing.
struct Lamp {
  double candela = 60.0;  ///< luminous intensity, the same in all directions within the cone
  double height = 0.8;    ///< of the light in parts of the thing's height; 0: just under the thing
  double cone = 0.0;      ///< degrees from straight down to the edge of its light; 0: all directions
};

/// Kinds of the same sort of thing for other places, by name; empty: there is none.
struct Forms {
  std::string small;    ///< stands on other things: a table lamp
  std::string wall;     ///< hangs on a wall: a wall lamp
  std::string ceiling;  ///< hangs from the ceiling: a pendant lamp
  std::string round;    ///< a round table
};

/// What is known about a kind of thing (docs/kinds.md). What an entry does not say of size, mount and
/// use, its parent says ("is": dining chair is chair is seat).
struct Kind {
  std::string name;    ///< "dining chair"
  std::string parent;  ///< may be empty
  std::vector<std::string> names;  ///< other names: "dinner chair"
  /// Other names among furniture only: a "screen" is a room divider in a list of what a room holds, and
  /// part of many things in a description of one.
  std::vector<std::string> loose_names;
  std::vector<std::string> lineage;  ///< itself and its ancestors; empty for an unknown kind

  Vec3 size{0.6, 0.6, 0.9};  ///< usual width, depth, height
  Mount mount = Mount::floor;
  std::vector<Mount> also;   ///< other ways to put it up (a television on the wall)
  double elevation = 0.0;    ///< usual height of the bottom above the floor, for Mount::wall
  Traits traits;
  bool supports = false;       ///< its top carries things
  bool covers_window = false;  ///< hangs before a window and is made to its measure: a curtain
  std::vector<UseZone> zones;  ///< usable when one is free and reachable; none: always usable
  std::vector<PreferredGap> gaps;
  std::vector<std::string> tucks_under;  ///< kinds it may slide under (a chair, a table)
  std::optional<Lamp> lamp;              ///< things of this kind shine
  Forms forms;

  bool variant = false;    ///< plans and scenes call it by its parent: an armoire is a wardrobe there
  std::string stocked_as;  ///< the kind as which libraries hold it: itself, or a variant's parent, unless said
  std::string built_as;    ///< the kind of data/shapes/kinds that is built for it: itself unless said
  std::string serves;      ///< who asks for that kind is served by this one: the parent unless said
  bool usual = false;      ///< what people mean when they say the name of the kind that it serves
  std::map<std::string, double> substitutes;  ///< kinds that will do, and how well, in (0, 1)
};

/// Is the kind the one of this name, or a descendant of it?
bool is_of(const Kind& kind, std::string_view name);
/// Is the kind one of these, or a descendant of one?
bool is_any_of(const Kind& kind, const std::vector<std::string>& kinds);

}  // namespace roomgen
