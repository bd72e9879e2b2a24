#pragma once

#include <optional>
#include <vector>

#include "columns.h"
#include "roomgen/scene/scene.h"
#include "roomgen/scene/object.h"
#include "support_surfaces.h"

namespace roomgen::detail {

/// What touches below: sampled points of a mesh's underside, heights from its bottom, and where its weight is.
struct Underside {
  std::vector<Vec3> points;
  Vec2 centroid = Vec2::Zero();
  bool stands = false;  ///< upright on a level floor
};

/// Is the point over the hull of the contacts?
bool is_over(const Vec2& point, std::vector<Vec2> contacts);

/// So far from a contact, metres, still touches.
inline constexpr double touching = 0.002;

/// The mesh of an object at its size, for what rests on others or carries them. Each part is made when
/// first asked for: most things only carry or are only carried.
class RestingBody {
 public:
  /// `models` must outlive this.
  RestingBody(const Object& object, const ModelTable& models) : object_(object), models_(models) {}

  const Object& object() const { return object_; }
  /// None of flat things.
  const std::vector<SupportSurface>& surfaces();
  const Columns& columns();
  const Underside& underside();

 private:
  const Mesh& mesh();
  Mesh without_panes() const;

  Object object_;
  const ModelTable& models_;
  std::optional<Mesh> mesh_;
  std::optional<Columns> columns_;
  std::optional<std::vector<SupportSurface>> surfaces_;
  std::optional<Underside> underside_;
};

}  // namespace roomgen::detail
