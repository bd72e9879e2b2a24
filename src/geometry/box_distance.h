#pragma once

#include "roomgen/geometry/model.h"

namespace roomgen {

inline double squared_distance(const Bounds3& a, const Bounds3& b) {
  return (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(Vec3::Zero()).squaredNorm();
}

inline double squared_distance(const Bounds3& box, const Vec3& point) {
  return (box.low - point).cwiseMax(point - box.high).cwiseMax(Vec3::Zero()).squaredNorm();
}

}  // namespace roomgen
