#pragma once

#include <string>
#include <vector>

#include "roomgen/geometry/model.h"
#include "roomgen/shape/program.h"

namespace roomgen::shape::detail {

/// A Material and how many metres of surface its texture covers (0: it has none).
struct Painted {
  Material material;
  double extent = 0.0;
};

/// Collects the materials of a program; those that look the same share one image.
class Surfaces {
 public:
  explicit Surfaces(const Program& program);

  /// Index of a program's material; the plain grey of what has none for "".
  int find(const std::string& name);
  /// Of a painted picture; `frame` is the component's material and gives the roughness.
  int picture(const PicturePart& picture, int frame);

  const std::vector<Painted>& all() const { return painted_; }

 private:
  int add(Painted painted);

  std::vector<Painted> painted_;
  std::vector<std::pair<std::string, int>> names_;
};

}  // namespace roomgen::shape::detail
