#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "facet.h"

namespace roomgen {

/// What a ray from a point to far away crosses. Of a closed surface whose triangles face outwards,
/// `winding` is above 0 inside; where nothing is known of the winding, an odd number of crossings
/// says so.
struct Enclosure {
  int winding = 0;    ///< crossings outwards less crossings inwards
  int crossings = 0;  ///< all
};

/// The triangles of a mesh sorted into axis-aligned boxes, for questions about what is near, ahead
/// or around. Parts of furniture mostly lie along the axes, and such boxes are made many times
/// faster than turned ones, whose directions take eigenvectors. Copies the triangles; may be asked
/// by several threads at once.
class MeshTree {
 public:
  explicit MeshTree(const Mesh& mesh);

  bool empty() const { return nodes_.empty(); }

  /// The surface's point nearest to `point`; nothing if none is nearer than `limit` metres.
  std::optional<Vec3> closest_point(
      const Vec3& point, double limit = std::numeric_limits<double>::infinity()) const;
  /// Is some triangle so near?
  bool within(const Vec3& point, double distance) const;

  /// Where the ray first meets a triangle, from either side, in lengths of its direction. What the
  /// origin lies on counts, up to a millionth of the direction behind it.
  std::optional<double> first_hit(const Ray& ray) const;
  Enclosure around(const Vec3& point) const;

  /// Of the surfaces; false, and `nearest` as it was, when they are not nearer than it says. Any
  /// points as near as `enough` will do.
  bool nearest(const MeshTree& other, NearestPoints& nearest, double enough = 0.0) const;

 private:
  struct Node {
    Bounds3 box;
    std::uint32_t first = 0, count = 0;  ///< facets; none: its halves are at `left` and `right`
    std::uint32_t left = 0, right = 0;
    bool is_leaf() const { return count > 0; }
  };
  class Build;
  class Nearest;

  template <typename Enters, typename Visit>
  void walk(Enters enters, Visit visit) const;

  std::vector<Node> nodes_;  ///< the first is the whole
  std::vector<Facet> facets_;
};

}  // namespace roomgen
