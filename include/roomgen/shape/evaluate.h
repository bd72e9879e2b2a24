#pragma once

#include <memory>
#include <string>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"
#include "roomgen/shape/program.h"

namespace roomgen::shape {

inline constexpr std::size_t max_triangles = 500'000;
/// What a piece of furniture should not exceed; see evaluate_within().
inline constexpr std::size_t default_triangles = 20'000;
inline constexpr double default_tolerance = 0.001;

/// One physical component: closed, outward, in the program's frame.
struct Body {
  std::string name;   ///< path of names: "leg-0", "drawer-2.handle"
  std::string label;  ///< the component's, else the enclosing group's, else its name
  Mesh mesh;
  int material = 0;                 ///< index into Shape::materials
  std::vector<std::size_t> source;  ///< indices to the component: in the program, in its group, …
};

struct Shape {
  std::vector<Body> bodies;
  /// The program's, in order, then those that pictures need. What no body has is not painted.
  std::vector<Material> materials;
};

/// Remembers meshes of single components, for who evaluates programs that differ little again and
/// again. Not for two threads at once.
class MeshMemory {
 public:
  MeshMemory();
  struct Impl;
  Impl& impl() const { return *impl_; }

 private:
  std::shared_ptr<Impl> impl_;
};

struct EvaluateOptions {
  double tolerance = default_tolerance;  ///< of chords of round surfaces, metres
  /// Textures take longer to paint than meshes to make; who only measures leaves them out.
  bool paint = true;
  /// With it the chords of scaled components are up to a fifth further off than they may be, so
  /// that components scaled a little more or less have the same mesh.
  const MeshMemory* memory = nullptr;
};
/// Coarse and without paint: enough to measure sides and to see whether a program makes sense.
inline const EvaluateOptions for_measuring{.tolerance = 0.01, .paint = false};

/// Meshes of a program. Copies are bodies of their own unless joined; joined ones are one body for
/// each material. `tolerance` bounds, in metres, how far chords may be from round surfaces. An
/// error names the component.
Result<Shape> evaluate(const Program& program, double tolerance = default_tolerance);
Result<Shape> evaluate(const Program& program, const EvaluateOptions& options);

/// With the tolerance doubled up to six times until there are no more than `triangles`; if there
/// still are, the coarsest.
Result<Shape> evaluate_within(const Program& program, std::size_t triangles = default_triangles,
                              double tolerance = default_tolerance);
Result<Shape> evaluate_within(const Program& program, std::size_t triangles,
                              const EvaluateOptions& options);

Bounds3 bounds(const Shape& shape);
std::size_t triangle_count(const Shape& shape);

/// Bodies merged by material, moved so that the bottom centre of the box is the origin.
Model to_model(const Shape& shape);

}  // namespace roomgen::shape
