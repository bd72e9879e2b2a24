#pragma once

#include <optional>
#include <span>

#include "roomgen/lab/program.h"
#include "roomgen/scene/room.h"
#include "slot_set.h"

namespace roomgen::lab::annealing {

/// How a thing of the state is put up against something: which of the faces that its relation allows.
struct Attachment {
  int relation = 0;            ///< which relation of the program's; see Language
  Slot target = room_slot;
  Face child = Face::bottom;
  Face parent = Face::floor;
  int wall = -1;               ///< for Face::wall
  double direction = 0.0;      ///< of the face of a round target, radians against its own frame

  bool operator==(const Attachment&) const = default;
};

bool is_level(Face face);     ///< floor, ceiling, top, bottom, support: it decides heights
bool is_upright(Face face);   ///< a side of a thing, a wall: it decides where and how turned

/// Where an upright attachment lets a thing be: turned to `yaw`, its centre c on the line c.normal = offset, from
/// `low` to `high` along left_of(normal).
struct Track {
  double yaw = 0.0;
  Vec2 normal = Vec2::Zero();
  double offset = 0.0;
  double low = 0.0;
  double high = 0.0;

  Vec2 at(double along) const { return offset * normal + along * left_of(normal); }
  double along(const Vec2& point) const { return left_of(normal).dot(point); }
  bool holds(const Vec2& point, double its_yaw, double tolerance) const;
};

/// The track along a wall for a thing of half extents `half`; nothing if the wall is too short.
std::optional<Track> track_along_wall(const PutUp& how, const Attachment& attachment, const Vec2& half,
                                      const Polygon& room);
/// The track along a side of another thing; nothing if the thing is wider than that side.
std::optional<Track> track_along_side(const PutUp& how, const Attachment& attachment, const Vec2& half,
                                      const Footprint& target);

/// What several tracks leave: nothing, a stretch, or one point (low == high). At least one track.
std::optional<Track> common_track(std::span<const Track> tracks);

}  // namespace roomgen::lab::annealing
