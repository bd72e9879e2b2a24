#include "rug_edges.h"

#include <algorithm>

#include "solve/fit_rugs.h"

namespace roomgen {

namespace {

bool may_meet(const Object& thing, const Object& rug) {
  return footprint(thing).bounds().overlaps(footprint(rug).bounds());
}

}  // namespace

bool lies_on_floor(const Object& object) { return object.traits.flat && object.mount == Mount::floor; }
bool stands_on_floor(const Object& object) { return object.mount == Mount::floor && !object.traits.flat; }

bool stands_on_edge(const Object& thing, const Object& rug, const ModelTable& models) {
  return may_meet(thing, rug) && stand_to_rug(thing, rug, models) == RugStand::partly;
}

std::optional<double> height_on_rugs(const Object& thing, std::span<const Object> objects, const ModelTable& models) {
  double height = 0.0;
  for (const auto& rug : objects) {
    if (!lies_on_floor(rug) || !may_meet(thing, rug)) continue;
    const RugStand stand = stand_to_rug(thing, rug, models);
    if (stand == RugStand::partly) return std::nullopt;
    if (stand == RugStand::on) height = std::max(height, top(rug));
  }
  return height;
}

std::string on_edge_of(const Object& rug, const Object* before, std::span<const Object> objects,
                       const ModelTable& models) {
  for (const auto& thing : objects)
    if (stands_on_floor(thing) && stands_on_edge(thing, rug, models) &&
        !(before && stands_on_edge(thing, *before, models)))
      return thing.id;
  return "";
}

}  // namespace roomgen
