#pragma once

#include "reply_notes.h"
#include "target_names.h"

namespace roomgen::design {

/// The constraints of an answer, however they are written: one text, a list of texts, of pairs or
/// of objects, an object with a member for each. What cannot be kept is noted in `notes`.
std::vector<Relation> read_reply_relations(const Json& value, const TargetNames& targets,
                                           ReplyNotes& notes);

/// Adds a relation that is not there yet and contradicts none that is; notes why it did not.
void add_relation(std::vector<Relation>& relations, const Relation& relation,
                  ReplyNotes& notes);

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

/// Where a thing shall look: a yaw, or at a target when that needs a location that is not known.
struct ReplyFacing {
  std::optional<double> yaw;
  std::optional<Relation> relation;
};

/// Degrees ("90 degrees": counter-clockwise, 0 looks to -y), a point of the compass (+y is north)
/// or a target. Notes what was not understood.
ReplyFacing read_reply_facing(const Json& value, const Scene& scene, const TargetNames& targets,
                              const std::optional<Vec2>& location,
                              ReplyNotes& notes);

}  // namespace roomgen::design
