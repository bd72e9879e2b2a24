#include "room_lights.h"

#include <algorithm>
#include <cmath>

#include "scene/lights.h"

namespace roomgen::detail {

namespace {

constexpr double exposure = 0.0035;     // of the picture, for a lux
constexpr double window_light = 0.3;             // what a square metre of window gives 1 m away
constexpr double before_window = 0.15;  // metres, lest the pane be brightest of all
constexpr std::size_t most_windows = 4;

std::vector<RoomLight> windows(const Room& room) {
  std::vector<const Opening*> openings;
  if (!is_day(room.light)) return {};
  for (const auto& opening : room.openings)
    if (opening.type == OpeningType::window) openings.push_back(&opening);
  const auto area = [](const Opening& o) { return o.width() * (o.head - o.sill); };
  std::stable_sort(openings.begin(), openings.end(),
                   [&](const Opening* a, const Opening* b) { return area(*a) > area(*b); });
  openings.resize(std::min(openings.size(), most_windows));
  std::vector<RoomLight> lights;
  for (const Opening* opening : openings) {
    const Vec2 in = inward(room, *opening);
    const Vec2 middle = segment(room, *opening).middle() + before_window * in;
    RoomLight light;
    light.place << middle, 0.5 * (opening->sill + opening->head);
    light.axis << in, 0.0;
    light.is_window = true;
    light.color = static_cast<float>(window_light * area(*opening)) * Eigen::Vector3f(0.92f, 0.97f, 1.0f);
    lights.push_back(light);
  }
  return lights;
}

std::vector<RoomLight> lamps(const Scene& scene) {
  auto lamps = lamp_lights(scene);
  std::stable_sort(lamps.begin(), lamps.end(),
                   [](const LampLight& a, const LampLight& b) { return a.candela > b.candela; });
  std::vector<RoomLight> lights;
  for (const auto& lamp : lamps) {
    RoomLight light;
    light.place = lamp.position;
    light.color = static_cast<float>(exposure * lamp.candela) * lamp.color;
    if (lamp.cone > 0) light.cosine = std::cos(lamp.cone);
    lights.push_back(light);
  }
  return lights;
}

}  // namespace

std::vector<RoomLight> room_lights(const Scene& scene) {
  std::vector<RoomLight> lights;
  for (const auto& room : rooms_of(scene))
    for (const auto& window : windows(room)) lights.push_back(window);
  for (const auto& lamp : lamps(scene)) lights.push_back(lamp);
  lights.resize(std::min(lights.size(), most_room_lights));
  return lights;
}

}  // namespace roomgen::detail
