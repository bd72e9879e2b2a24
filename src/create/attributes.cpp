#include "attributes.h"

#include <algorithm>

namespace roomgen::create {

void apply(const Attributes& from, PartWish& part) {
  const auto take = [](const std::string& said, std::string& to) {
    if (!said.empty()) to = said;
  };
  take(from.shape, part.shape);
  take(from.construction, part.construction);
  take(from.material, part.material);
  take(from.color, part.color);
  take(from.direction, part.direction);
  if (from.count && !part.count) part.count = from.count;
  if (from.lean) part.lean = from.lean;
  if (from.course) part.course = from.course;
  if (from.strength) part.strength = *from.strength;
  part.scale = part.scale.cwiseProduct(from.scale);
}

void apply(const Attributes& from, Description& object) {
  if (!from.material.empty()) object.material = from.material;
  if (!from.color.empty()) object.color = from.color;
  if (!from.style.empty()) object.style = from.style;
  object.scale = object.scale.cwiseProduct(from.scale);
  if (from.shape.empty() && from.construction.empty() && !from.course && !from.lean) return;
  const bool known = std::any_of(object.parts.begin(), object.parts.end(),
                                 [](const PartWish& part) { return part.label.empty(); });
  if (!known) object.parts.insert(object.parts.begin(), PartWish());
  Attributes rest = from;
  rest.count.reset();
  rest.material.clear(), rest.color.clear();
  rest.scale = Vec3::Ones();
  apply(rest, object.parts.front());
}

}  // namespace roomgen::create
