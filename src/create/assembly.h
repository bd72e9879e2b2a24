#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "collision/mesh_distance.h"
#include "roomgen/base/result.h"
#include "roomgen/shape/evaluate.h"
#include "roomgen/shape/program.h"

namespace roomgen::create::detail {

/// Indices to a component: in the program, in its group, …
using ComponentPath = std::vector<std::size_t>;

/// A body of a program as the validator sees it.
struct Part {
  std::string name, label;
  ComponentPath source;
  MeshSolid solid;
  double volume = 0.0;
  Vec3 centroid = Vec3::Zero();  ///< of the volume
  std::uint64_t id = 0;          ///< of this mesh; a part that is made anew has another

  const Bounds3& box() const { return solid.box(); }
};

shape::Component& component_at(shape::Program& program, const ComponentPath& path);
const shape::Component& component_at(const shape::Program& program, const ComponentPath& path);
bool starts_with(const ComponentPath& path, const ComponentPath& prefix);

/// A program and its bodies. Copies share what they have in common, so that trying a change costs
/// no more than what it changes; what was measured between two parts is not measured again.
class Assembly {
 public:
  static Result<Assembly> make(const shape::Program& program, double contact);
  /// For measuring only: bodies without a program.
  static Assembly of(const shape::Shape& shape, double contact);

  const shape::Program& program() const { return program_; }
  /// In the order of the program's bodies; a change keeps number and order.
  const std::vector<Part>& parts() const { return parts_; }
  double contact() const { return contact_; }

  /// Replaces a component of the program. False, and nothing changed, when it cannot be made, or
  /// makes another number of bodies.
  bool replace(std::size_t top, const shape::Component& component);

  bool touch(std::size_t a, std::size_t b) const;
  /// They touch, but only in a point although both are thick.
  bool touch_in_a_point(std::size_t a, std::size_t b) const;
  NearestPoints nearest(std::size_t a, std::size_t b) const;
  /// Parts that touch each part.
  std::vector<std::vector<std::size_t>> contacts() const;

  /// Of its components, and of those that were tried.
  const shape::MeshMemory& meshes() const;
  /// How much was computed so far by this assembly and its copies, in triangles or so.
  std::uint64_t work() const;

 private:
  struct Memory;
  Assembly() = default;

  shape::Program program_;
  std::vector<Part> parts_;
  double contact_ = 0.002;
  std::shared_ptr<Memory> memory_;
};

}  // namespace roomgen::create::detail
