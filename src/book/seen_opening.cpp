#include "seen_opening.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace roomgen::book {

std::vector<SeenOpening> openings_seen(const Room& room) {
  const Bounds2 box = bounds(room.polygon);
  std::vector<SeenOpening> seen;
  for (const auto& opening : room.openings) {
    const Vec2 out = -inward(room, opening), middle = segment(room, opening).middle() - box.low;
    SeenOpening one;
    if (std::abs(out.x()) > std::abs(out.y()))
      one.side = out.x() > 0.0 ? 1 : 3;
    else
      one.side = out.y() > 0.0 ? 2 : 0;
    one.middle = one.side % 2 == 0 ? middle.x() : middle.y();
    one.width = opening.width(), one.sill = opening.sill, one.is_window = !opening.is_entrance();
    seen.push_back(one);
  }
  return seen;
}

bool is_window(const Json& opening) {
  return opening.value("kind", std::string()).find("window") != std::string::npos;
}

}  // namespace roomgen::book
