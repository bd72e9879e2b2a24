#include "lights.h"

#include <algorithm>
#include <cmath>

#include "roomgen/geometry/model.h"

namespace roomgen {

namespace {

constexpr double under_lamp = 0.03;     // metres below a lamp that shines under itself
constexpr double from_surfaces = 0.02;  // least distance from walls, floor and ceiling
const double sun_elevation = radians(38.0), sun_azimuth = radians(30.0);
// A low sun through haze. The full one, a hundred times as bright, would leave lamps invisible and
// viewers without an exposure white.
constexpr double sun_lux = 1000.0;
constexpr double incandescent = 2850.0;  // kelvin
constexpr double sunrise = 6.0, sunset = 20.0;  // hours, where nobody says the season

Eigen::Vector3f linear(float r, float g, float b) {
  return {linear_from_srgb(r), linear_from_srgb(g), linear_from_srgb(b)};
}

// The nearest point that is inside the room, a little off its walls.
Vec2 moved_inside(const Polygon& polygon, Vec2 point) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Segment wall = polygon.edge(k);
    const Vec2 inward = polygon.inward(k);
    const double along = (point - wall.a).dot(wall.direction());
    const double depth = (point - wall.a).dot(inward);
    const bool beside = along > -from_surfaces && along < wall.length() + from_surfaces;
    if (beside && depth < from_surfaces && depth > -0.5) point += (from_surfaces - depth) * inward;
  }
  return point;
}

Vec3 place_of(const Object& object, const Lamp& lamp, const Room& room) {
  const double z = lamp.height > 0 ? bottom(object) + lamp.height * object.size.z()
                                   : bottom(object) - under_lamp;
  const Vec2 p = moved_inside(room.polygon, object.position.head<2>());
  return {p.x(), p.y(), std::clamp(z, from_surfaces, room.height - from_surfaces)};
}

bool burns(const Object& lamp, const Lighting& light, const KindTable& table) {
  return !light.lamps ||
         std::any_of(light.lamps->begin(), light.lamps->end(), [&](const std::string& said) {
           return said == "all" || said == lamp.id || table.is_a(lamp.category, said);
         });
}

const Opening* widest_window(const Room& room) {
  const Opening* widest = nullptr;
  for (const auto& opening : room.openings)
    if (opening.type == OpeningType::window &&
        (!widest || opening.width() > widest->width() + 1e-9))
      widest = &opening;
  return widest;
}

// How far a ray runs inside the room.
double free_way(const Room& room, const Vec2& from, const Vec2& direction) {
  double nearest = 1e9;
  for (std::size_t k = 0; k < room.polygon.size(); ++k) {
    const Segment wall = room.polygon.edge(k);
    const Vec2 along = wall.b - wall.a;
    const double turn = cross(direction, along);
    if (std::abs(turn) < 1e-12) continue;
    const double distance = cross(wall.a - from, along) / turn;
    const double at = cross(wall.a - from, direction) / turn;
    if (distance > 1e-6 && at >= 0 && at <= 1) nearest = std::min(nearest, distance);
  }
  return nearest;
}

}  // namespace

std::vector<LampLight> lamp_lights(const Scene& scene, const KindTable& table) {
  std::vector<LampLight> lights;
  for (const auto& object : scene.objects) {
    const Kind& category = table.get(object.category);
    const Room& room = room_of(scene, object);
    if (!category.lamp || !burns(object, room.light, table)) continue;
    lights.push_back({object.id, place_of(object, *category.lamp, room), category.lamp->candela,
                      radians(category.lamp->cone),
                      lamp_color(room.light.kelvin.value_or(incandescent))});
  }
  return lights;
}

std::optional<Sunlight> sunlight(const Room& room) {
  const Opening* window = widest_window(room);
  if (!window || !is_day(room.light) || room.light.sky == Sky::overcast) return std::nullopt;
  const Segment line = segment(room, *window);
  const Vec2 middle = 0.5 * (line.a + line.b), in = inward(room, *window);
  const Vec2 left = rotated(in, sun_azimuth), right = rotated(in, -sun_azimuth);
  const Vec2 way =
      free_way(room, middle + 1e-3 * in, left) >= free_way(room, middle + 1e-3 * in, right) ? left
                                                                                            : right;
  Sunlight sun;
  sun.to_sun << -std::cos(sun_elevation) * way, std::sin(sun_elevation);
  sun.lux = sun_lux;
  return sun;
}

bool is_day(const Lighting& light) {
  if (light.sky) return *light.sky != Sky::night;
  return !light.hour || (*light.hour >= sunrise && *light.hour <= sunset);
}

// Planck's law at the wavelengths of the primaries of sRGB, against a white to which eyes have half
// adapted.
Eigen::Vector3f lamp_color(double kelvin) {
  constexpr double second_radiation = 1.438777e7;  // nanometres times kelvin
  constexpr double white = 4400.0;
  Eigen::Vector3f color;
  int channel = 0;
  for (const double nanometres : {612.0, 549.0, 464.0})
    color[channel++] = static_cast<float>(std::expm1(second_radiation / (nanometres * white)) /
                                          std::expm1(second_radiation / (nanometres * kelvin)));
  return color / color.maxCoeff();
}

Eigen::Vector3f sun_color() {
  return linear(255, 244, 228);
}

}  // namespace roomgen
