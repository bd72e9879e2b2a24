#pragma once

#include <vector>

#include "base/random.h"
#include "brief/brief.h"
#include "brief/room_kinds.h"
#include "looks.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/plan.h"

namespace roomgen::plan {

/// Things that a room holds where they fit.
inline constexpr int fewest_things = 8;

/// A plan item that is not yet in order: what it demands of others is still by mention.
struct Draft {
  PlanItem item;
  std::size_t mention =
      brief::Demand::none;  ///< index into Brief::mentions, none for what was added
  std::size_t part_of = brief::Demand::none;  ///< the mention of which these are some
  std::optional<std::size_t> origin;  ///< of what is in order: which draft it was before; none: a group added it
  std::vector<brief::Demand> demands;
  std::optional<brief::Formation> formation;  ///< of its things
  int seats = 0;      ///< of a table: for so many people; 0: not said
  bool sized = false;  ///< something is said of its size
  bool core = false;  ///< the room is hardly one of its kind without it
};

/// What the prompt asks for.
std::vector<Draft> asked_items(const brief::Brief& brief, const KindTable& table);

/// Curtains and blinds (Kind::covers_window) that are only named in the plural hang at every window.
void one_for_each_window(std::vector<Draft>& drafts, const brief::Brief& brief, const Room& room,
                         const KindTable& table);

/// Floor that things cover: no rugs, nothing on walls or on other things.
double floor_area(const PlanItem& item, const KindTable& table);
double floor_area(const std::vector<Draft>& drafts, const KindTable& table);

/// Adds what such a room usually holds and the prompt neither names nor forbids: its core, then
/// extras up to a number of things and a share of the floor, then what goes on walls and tables.
void complete(std::vector<Draft>& drafts, const brief::Brief& brief, const brief::RoomKinds& kinds,
              const brief::RoomKind& kind, const Vec2& room, const KindTable& table,
              const Looks& looks, Random random);

/// Makes the tables that the prompt asks for, without saying how large, fit the seats it asks for.
void fit_tables(std::vector<Draft>& drafts, const brief::Brief& brief, const KindTable& table);

}  // namespace roomgen::plan
