#pragma once

#include "base/random.h"
#include "brief/brief.h"
#include "brief/outline.h"
#include "brief/room_kinds.h"
#include "library/style_words.h"
#include "room_openings.h"
#include "roomgen/scene/room.h"

namespace roomgen::plan {

/// Largest floor that is chosen rather than asked for.
inline constexpr double max_chosen_area = 100.0;

/// By how much the words of style make both sides of a room longer ("grand") or shorter ("tiny").
double size_factor(const brief::RoomKinds& kinds, const std::vector<std::string>& styles);

/// Width and depth for a room: what is asked, else chosen by its kind and large enough for
/// `furniture` square metres of things, and for a block of them with the ways around it, metres.
Vec2 choose_size(const brief::RoomKind& kind, const brief::Brief& brief, double scale,
                 double furniture, const Vec2& block, Random random);

/// The floor that the prompt asks for. `chosen` is its box if that is asked for, else that of a
/// rectangle of the area that it shall have. Fills `notes` with what had no place.
brief::Outline choose_outline(const brief::Brief& brief, const Vec2& chosen, bool is_box,
                       std::vector<std::string>& notes, Random random);

/// A room of that floor with its doors and windows. Fills `notes` with what has no place as it is wished for.
Room make_room(const brief::RoomKind& kind, const brief::Outline& outline,
               const RoomOpenings& openings, Random random, std::vector<std::string>& notes);

/// Walls and floor of a style; floors that get wet keep their tiles.
void put_on(Room& room, const StyleMeaning& style, Random random);
/// What the prompt says of materials, in place of what the room has.
void put_on(Room& room, const RoomMaterials& said);

/// What the prompt calls a part of the room ("wall-3": the left wall), as the room has it.
std::string part_of(const Room& room, const std::string& said);

}  // namespace roomgen::plan
