#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "roomgen/geometry/model.h"
#include "roomgen/scene/scene.h"
#include "roomgen/view/view.h"

namespace roomgen {

/// A camera with parallel rays, or with an eye that all rays meet in. Its axes are unit vectors in room
/// coordinates; `backward` points from the scene to the viewer. Pixels count from the top left corner of
/// the picture.
struct Camera {
  int width = 0, height = 0;  ///< pixels
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitY(), backward = Vec3::UnitZ();
  Vec2 center = Vec2::Zero();  ///< of the picture, metres along right and up (with an eye: in the plane
                               ///< 1 m before it, from the point that it looks at)
  double pixels_per_metre = 100.0;  ///< with an eye: of what is 1 m before it
  double near = 0.0, far = 0.0;  ///< the scene lies within, metres along backward; near > far
  std::optional<Vec3> eye = std::nullopt;

  /// Of a point before the eye, if there is one.
  Vec2 pixel(const Vec3& point) const;
  /// Metres along `backward`.
  double depth(const Vec3& point) const { return backward.dot(point); }
};

inline constexpr int min_picture_pixels = 16;
inline constexpr int max_picture_pixels = 4096;
/// Where the top view cuts the walls, metres above the floor.
inline constexpr double plan_cut_height = 1.2;
/// What remains of walls between the viewer and the room.
inline constexpr double hidden_wall_height = 0.08;
/// What remains of walls between rooms in the isometric view: enough to see where doors are.
inline constexpr double inner_wall_height = 0.9;

/// Height of the eye of a standing person above the floor, metres (Neufert, Architects' Data).
inline constexpr double eye_level = 1.6;
/// From side to side of what the eye-level view shows, radians.
inline constexpr double eye_view_angle = 1.4;
/// Free space around the eye, metres, wherever the room has any.
inline constexpr double eye_clearance = 0.2;

/// The camera of a view: from above fitted to the room with its walls and to the objects; at eye level
/// before a door or in a corner, wherever it sees most, with upright verticals. Fails if `pixels` is out of
/// bounds or the room has no extent.
Result<Camera> make_camera(const Scene& scene, const View& view);

/// The eight corners of the object's placed box.
std::vector<Vec3> box_corners(const Object& object);

/// Heights to draw the walls of rooms[index] with: the top view cuts them, the isometric view
/// lowers those that would hide floor, those between rooms less than the others, at eye level they are
/// whole.
std::vector<double> wall_heights(std::span<const Room> rooms, std::size_t index, const View& view,
                                 const Camera& camera);

/// Does the object hang on a wall that is drawn too low to hold it? It would float in the air.
bool hangs_on_lowered_wall(const Room& room, const Object& object,
                           const std::vector<double>& heights);

}  // namespace roomgen
