#pragma once

#include <optional>

#include "reply_notes.h"
#include "roomgen/base/json.h"
#include "roomgen/geometry/polygon.h"

namespace roomgen::design {

/// Which coordinates an answer uses.
enum class MarksFrame {
  plan,   ///< the scene's: x to the right, y up
  paper,  ///< [down from the top, left from the right] of the room's bounding box
};

/// The location of an answer in the scene's frame, inside the room: as it is given, or in
/// centimetres or millimetres, or with its coordinates swapped, or moved into the room by at most a
/// metre. Notes what it did and why there is none.
std::optional<Vec2> read_reply_location(const Json& value, const Polygon& room, MarksFrame frame,
                                        ReplyNotes& notes);

}  // namespace roomgen::design
