#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "color.h"
#include "pattern.h"
#include "roomgen/geometry/model.h"
#include "roomgen/shape/program.h"

namespace roomgen::shape::detail {

/// A Material, how many metres of surface its texture covers (0: it has none), and what of.
struct Painted {
  Material material;
  double extent = 0.0;
  Pattern pattern = Pattern::none;
  Rgb first = {}, second = {};
  std::optional<PicturePart> picture;  ///< also one that covers it again and again
};

/// Collects the materials of a program. Textures are painted at last, and only where they show;
/// those that look the same are one image.
class Surfaces {
 public:
  explicit Surfaces(const Program& program);

  /// Index of a program's material; the plain grey of what has none for "".
  int find(const std::string& name);
  /// Of a painted picture; `frame` is the component's material and gives the roughness.
  int picture(const PicturePart& picture, int frame);

  const std::vector<Painted>& all() const { return painted_; }
  /// The materials, painted.
  std::vector<Material> paint(const std::vector<bool>& used);

 private:
  int add(Painted painted);
  std::shared_ptr<const Image> texture(const Painted& painted);

  std::vector<Painted> painted_;
  std::vector<std::pair<std::string, int>> names_;
  std::map<std::tuple<Pattern, Rgb, Rgb>, std::shared_ptr<const Image>> patterns_;
  std::map<std::tuple<std::string, std::uint64_t, double, int>, int> pictures_;
};

}  // namespace roomgen::shape::detail
