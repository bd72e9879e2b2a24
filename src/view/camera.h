#pragma once

#include <span>
#include <vector>

#include "roomgen/geometry/model.h"
#include "roomgen/scene/scene.h"
#include "roomgen/view/view.h"

namespace roomgen {

inline constexpr int min_picture_pixels = 16;
inline constexpr int max_picture_pixels = 4096;
/// Is a picture's side within these bounds?
Status check_picture_side(int pixels);
/// Is the picture of a sensible size, and are the axes three that are upright on each other?
Status check_camera(const Camera& camera);

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
