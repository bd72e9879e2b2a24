#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "assembly.h"

namespace roomgen::create::detail {

/// A way to change a component that leaves copies copies.
struct Handle {
  enum class Kind {
    move,      ///< its `at`: three amounts
    stretch,   ///< its `scale` along one axis of its own: one amount, metres
    path_end,  ///< the first or last point of a sweep's path, the others along with it: three
               ///< amounts
    widen,     ///< its `scale` across the vertical: one amount, the factor less 1
  };
  Kind kind = Kind::move;
  ComponentPath path;
  int axis = 0;
  double anchor = 0.0;  ///< of a stretch: what stays; 0 the low end, 1 the high one, 0.5 the middle
  bool first = false;   ///< of a path

  int amounts() const { return kind == Kind::move || kind == Kind::path_end ? 3 : 1; }
};

/// False, and nothing changed, when the component cannot be changed so, or not so far.
bool pull(Assembly& assembly, const Handle& handle, const Eigen::VectorXd& amounts);

/// Where a part should be moved: the vertex of it that shall go elsewhere.
struct Wish {
  std::size_t part = 0;
  std::size_t vertex = 0;
  Vec3 move = Vec3::Zero();
};

std::size_t nearest_vertex(const Part& part, const Vec3& point);

/// The amounts that fulfil the wishes best (least squares); nothing when the handle moves none of
/// them. What a group or an operation does to the handle's amounts is found by trying.
std::optional<Eigen::VectorXd> solve(const Assembly& assembly, const Handle& handle,
                                     const std::vector<Wish>& wishes);

}  // namespace roomgen::create::detail
