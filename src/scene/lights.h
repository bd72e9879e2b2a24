#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// A lamp that is turned on, in room coordinates.
struct LampLight {
  std::string object;           ///< the id of the thing that shines
  Vec3 position = Vec3::Zero();
  double candela = 0.0;         ///< luminous intensity within the cone
  double cone = 0.0;            ///< radians from straight down to its edge; 0: shines in all directions
  Eigen::Vector3f color = Eigen::Vector3f::Ones();  ///< linear, 1 in the strongest channel
};

/// One light for every object whose kind is a lamp (data/kinds) and which burns (Lighting::lamps),
/// in the scene's order: within its box where the shade is, or just under it. All are inside the
/// room: what hangs over a wall is moved in.
std::vector<LampLight> lamp_lights(const Scene& scene,
                                   const KindTable& table = KindTable::built_in());

/// The sun, as parallel light.
struct Sunlight {
  Vec3 to_sun = Vec3::UnitZ();  ///< unit vector
  double lux = 0.0;             ///< on a surface that faces it
};

/// The sun as it shines into the widest window (of equally wide ones the first): 38 degrees above
/// the horizon and 30 degrees beside the window's normal, on the side that leaves the longer way
/// across the floor. None for a room without windows, nor by night, under an overcast sky or at an
/// hour without sun.
std::optional<Sunlight> sunlight(const Room& room);

/// Does the sky outside give light?
bool is_day(const Lighting& light);

/// Linear colours of light, 1 in the strongest channel: of a black body, and of the sun.
Eigen::Vector3f lamp_color(double kelvin);
Eigen::Vector3f sun_color();

}  // namespace roomgen
