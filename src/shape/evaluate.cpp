#include "roomgen/shape/evaluate.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "placing.h"
#include "roomgen/shape/primitives.h"
#include "solid_mesh.h"
#include "surfaces.h"

namespace roomgen::shape {

namespace {

using namespace detail;

constexpr int max_coarser = 6;
constexpr std::size_t most_remembered = 256;

// What a component takes from the groups around it.
struct Around {
  std::string path;  ///< for messages
  std::string label, material;
  std::vector<std::size_t> source;
  double tolerance = default_tolerance;
};

std::size_t triangles_in(const std::vector<Body>& bodies) {
  std::size_t count = 0;
  for (const auto& body : bodies) count += body.mesh.triangles.size();
  return count;
}

std::size_t times(const Operation& operation) {
  if (std::holds_alternative<Mirror>(operation)) return 2;
  if (const auto* array = std::get_if<Array>(&operation)) return std::max(array->count, 0);
  if (const auto* radial = std::get_if<Radial>(&operation)) return std::max(radial->count, 0);
  return 1;
}

bool same(const Solid& a, const Solid& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&]<typename T>(const T& solid) {
        if constexpr (std::is_same_v<T, Group>)
          return false;
        else
          return solid == std::get<T>(b);
      },
      a);
}

}  // namespace

struct MeshMemory::Impl {
  struct Entry {
    Solid solid;
    std::vector<Cut> cuts;
    double tolerance = 0.0;
    Mesh mesh;
  };

  const Mesh* find(const Solid& solid, const std::vector<Cut>& cuts, double tolerance) const {
    for (const auto& entry : entries_)
      if (entry.tolerance == tolerance && entry.cuts == cuts && same(entry.solid, solid))
        return &entry.mesh;
    return nullptr;
  }

  void keep(Entry entry) {
    if (entries_.size() < most_remembered) return entries_.push_back(std::move(entry));
    entries_[oldest_] = std::move(entry);
    oldest_ = (oldest_ + 1) % most_remembered;
  }

 private:
  std::vector<Entry> entries_;
  std::size_t oldest_ = 0;
};

MeshMemory::MeshMemory() : impl_(std::make_shared<Impl>()) {}

namespace {

class Evaluator {
 public:
  Evaluator(const Program& program, const MeshMemory* memory)
      : surfaces_(program), memory_(memory) {}

  Result<std::vector<Body>> all(const std::vector<Component>& components, const Around& around) {
    std::vector<Body> result;
    std::size_t triangles = 0;
    for (std::size_t k = 0; k < components.size(); ++k) {
      Around own = around;
      own.source.push_back(k);
      own.path += (around.path.empty() ? "" : ".") + components[k].name;
      auto bodies = one(components[k], own);
      if (!bodies) return bodies.error();
      triangles += triangles_in(*bodies);
      if (triangles > max_triangles) return too_many(own);
      std::move(bodies->begin(), bodies->end(), std::back_inserter(result));
    }
    return result;
  }

  Surfaces& surfaces() { return surfaces_; }

 private:
  static Error too_many(const Around& around) {
    return {Error::Kind::limit, "component \"" + around.path + "\": more than " +
                                    std::to_string(max_triangles) +
                                    " triangles; use fewer copies or a coarser tolerance"};
  }

  Result<std::vector<Body>> one(const Component& component, Around around) {
    if (!component.label.empty()) around.label = component.label;
    if (!component.material.empty()) around.material = component.material;
    double grows = component.scale.cwiseAbs().maxCoeff();
    if (memory_) grows = std::exp2(0.5 * std::round(2.0 * std::log2(std::max(grows, 1e-6))));
    around.tolerance = std::clamp(around.tolerance / std::max(grows, 1e-6), 1e-5, 1.0);
    auto bodies = own_frame(component, around);
    if (!bodies) return bodies;
    for (auto& body : *bodies) detail::place(body.mesh, placement(component));

    Copies copies = {*std::move(bodies)};
    for (const auto& operation : component.operations) {
      std::size_t triangles = 0;
      for (const auto& copy : copies) triangles += triangles_in(copy);
      if (triangles * times(operation) > max_triangles) return too_many(around);
      apply(operation, copies);
    }
    return named(component, std::move(copies));
  }

  Result<std::vector<Body>> own_frame(const Component& component, const Around& around) {
    const std::vector<Cut> cuts = cuts_of(component);
    const auto* group = std::get_if<Group>(&component.solid);
    if (!group) {
      auto mesh = own_mesh(component.solid, cuts, around);
      if (!mesh) return mesh.error();
      if (!cuts.empty() && mesh->triangles.empty()) return std::vector<Body>();
      return std::vector<Body>{body(component, around, *std::move(mesh))};
    }
    auto bodies = all(group->components, around);
    if (!bodies || cuts.empty()) return bodies;
    for (auto& one : *bodies)
      if (auto status = cut_off(one.mesh, cuts, around); !status) return status.error();
    std::erase_if(*bodies, [](const Body& one) { return one.mesh.triangles.empty(); });
    return bodies;
  }

  static std::vector<Cut> cuts_of(const Component& component) {
    std::vector<Cut> cuts;
    for (const auto& operation : component.operations)
      if (const auto* plane = std::get_if<Cut>(&operation)) cuts.push_back(*plane);
    return cuts;
  }

  static Status cut_off(Mesh& mesh, const std::vector<Cut>& cuts, const Around& around) {
    for (const auto& plane : cuts) {
      if (mesh.triangles.empty()) break;
      auto rest = cut(mesh, plane.point, plane.normal);
      if (!rest) return with_context(rest.error(), "component \"" + around.path + "\": cut");
      mesh = *std::move(rest);
    }
    return {};
  }

  Result<Mesh> own_mesh(const Solid& solid, const std::vector<Cut>& cuts, const Around& around) {
    if (memory_)
      if (const Mesh* known = memory_->impl().find(solid, cuts, around.tolerance)) return *known;
    auto made = solid_mesh(solid, around.tolerance);
    if (!made) return with_context(made.error(), "component \"" + around.path + "\"");
    if (auto status = cut_off(*made, cuts, around); !status) return status.error();
    if (memory_) memory_->impl().keep({solid, cuts, around.tolerance, *made});
    return made;
  }

  Body body(const Component& component, const Around& around, Mesh mesh) {
    Body result;
    result.label = around.label.empty() ? component.name : around.label;
    result.mesh = std::move(mesh);
    result.material = surfaces_.find(around.material);
    if (const auto* picture = std::get_if<PicturePart>(&component.solid))
      result.material = surfaces_.picture(*picture, result.material);
    result.source = around.source;
    return result;
  }

  static std::vector<Body> named(const Component& component, Copies copies) {
    std::vector<Body> result;
    for (std::size_t k = 0; k < copies.size(); ++k) {
      const std::string name =
          component.name + (copies.size() > 1 ? "-" + std::to_string(k) : std::string());
      for (auto& body : copies[k]) {
        body.name = body.name.empty() ? name : name + "." + body.name;
        result.push_back(std::move(body));
      }
    }
    return result;
  }

  Surfaces surfaces_;
  const MeshMemory* memory_;
};

// With materials that are not painted yet.
struct Unpainted {
  std::vector<Body> bodies;
  Surfaces surfaces;
};

Result<Unpainted> meshes(const Program& program, double tolerance, const MeshMemory* memory) {
  if (!(tolerance >= 1e-5 && tolerance <= 1.0))
    return Error{Error::Kind::invalid_input, "the tolerance must be from 0.00001 to 1 m"};
  if (component_count(program.components) > max_components)
    return Error{Error::Kind::limit,
                 "more than " + std::to_string(max_components) + " components, copies counted"};
  Evaluator evaluator(program, memory);
  Around around;
  around.tolerance = tolerance;
  auto bodies = evaluator.all(program.components, around);
  if (!bodies) return bodies.error();
  if (bodies->empty()) return Error{Error::Kind::invalid_input, "the program makes no solid"};
  return Unpainted{*std::move(bodies), std::move(evaluator.surfaces())};
}

Shape painted(Unpainted made, bool paint) {
  const auto& all = made.surfaces.all();
  std::vector<bool> used(all.size(), false);
  for (auto& body : made.bodies) {
    const auto material = static_cast<std::size_t>(body.material);
    used[material] = paint;
    const double extent = all[material].extent;
    if (extent > 0.0)
      for (auto& uv : body.mesh.uvs) uv /= static_cast<float>(extent);
  }
  return {std::move(made.bodies), made.surfaces.paint(used)};
}

}  // namespace

Result<Shape> evaluate(const Program& program, double tolerance) {
  return evaluate(program, EvaluateOptions{.tolerance = tolerance});
}

Result<Shape> evaluate(const Program& program, const EvaluateOptions& options) {
  auto made = meshes(program, options.tolerance, options.memory);
  if (!made) return made.error();
  return painted(*std::move(made), options.paint);
}

Result<Shape> evaluate_within(const Program& program, std::size_t triangles, double tolerance) {
  return evaluate_within(program, triangles, EvaluateOptions{.tolerance = tolerance});
}

Result<Shape> evaluate_within(const Program& program, std::size_t triangles,
                              const EvaluateOptions& options) {
  double tolerance = options.tolerance;
  auto made = meshes(program, tolerance, options.memory);
  for (int k = 0; k < max_coarser; ++k) {
    const bool fits = made && triangles_in(made->bodies) <= triangles;
    const bool hopeless = !made && made.error().kind != Error::Kind::limit;
    if (fits || hopeless) break;
    tolerance *= 2;
    made = meshes(program, tolerance, options.memory);
  }
  if (!made) return made.error();
  return painted(*std::move(made), options.paint);
}

Bounds3 bounds(const Shape& shape) {
  Bounds3 box;
  for (const auto& body : shape.bodies)
    for (const auto& p : body.mesh.positions) box.add(p.cast<double>());
  return box;
}

std::size_t triangle_count(const Shape& shape) {
  return triangles_in(shape.bodies);
}

Model to_model(const Shape& shape) {
  const Bounds3 box = bounds(shape);
  const Eigen::Vector3f origin =
      Vec3(box.center().x(), box.center().y(), box.low.z()).cast<float>();
  Model model;
  std::vector<int> part_of(shape.materials.size(), -1);
  for (const auto& body : shape.bodies) {
    int& part = part_of[static_cast<std::size_t>(body.material)];
    if (part < 0) {
      part = static_cast<int>(model.parts.size());
      model.parts.push_back({{}, static_cast<int>(model.materials.size())});
      model.materials.push_back(shape.materials[static_cast<std::size_t>(body.material)]);
    }
    Mesh& mesh = model.parts[static_cast<std::size_t>(part)].mesh;
    const std::size_t first = mesh.positions.size();
    append_mesh(mesh, body.mesh);
    for (std::size_t k = first; k < mesh.positions.size(); ++k) mesh.positions[k] -= origin;
  }
  return model;
}

}  // namespace roomgen::shape
