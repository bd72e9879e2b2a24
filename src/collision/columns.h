#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "roomgen/geometry/model.h"
#include "roomgen/geometry/polygon.h"

namespace roomgen::detail {

/// Where a vertical line meets a mesh.
struct Crossing {
  double z = 0.0;
  double slope = 0.0;  ///< z of the face's unit normal
};

/// A mesh prepared for vertical lines: triangles by the cells of a grid that they are over.
class Columns {
 public:
  explicit Columns(const Mesh& mesh);

  const Bounds3& box() const { return box_; }
  /// From below; one for faces that lie on each other, the one that looks most upwards.
  void crossings(const Vec2& at, std::vector<Crossing>& found) const;
  /// The highest in a range of heights.
  std::optional<double> highest(const Vec2& at, double low, double high) const;
  std::optional<double> lowest(const Vec2& at) const;

 private:
  struct Face {
    Vec3 a;
    Vec2 ab, ac;          // seen from above
    double rise_b = 0.0;  // heights of the other two corners above a
    double rise_c = 0.0;
    double inverse = 0.0;  // of twice the signed area seen from above
    double slope = 0.0;
  };
  template <typename Visit>
  void visit(const Vec2& at, const Visit& visit) const;

  Bounds3 box_;
  int nx_ = 0, ny_ = 0;
  std::vector<std::uint32_t> first_;  // of each cell, in faces_of_cells_
  std::vector<std::uint32_t> faces_of_cells_;
  std::vector<Face> faces_;
};

}  // namespace roomgen::detail
