#pragma once

#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "roomgen/geometry/model.h"
#include "roomgen/shape/color.h"
#include "roomgen/shape/pattern.h"
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
  Painted painted(const Surface& surface);
  int add(Painted painted);

  std::vector<Painted> painted_;
  std::vector<std::pair<std::string, int>> names_;
  std::map<std::tuple<Pattern, Rgb, Rgb>, std::shared_ptr<const Image>> patterns_;
  std::map<std::tuple<std::string, std::uint64_t, double, int>, int> pictures_;
};

}  // namespace roomgen::shape::detail
