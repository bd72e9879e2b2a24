#include "handles.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace roomgen::create::detail {

namespace {

constexpr double least_factor = 0.3, greatest_factor = 3.5;
constexpr double greatest_scale = 1000.0;

Eigen::Matrix3d rotation(const shape::Component& component) {
  return (Eigen::AngleAxisd(component.rotate.z(), Vec3::UnitZ()) *
          Eigen::AngleAxisd(component.rotate.y(), Vec3::UnitY()) *
          Eigen::AngleAxisd(component.rotate.x(), Vec3::UnitX()))
      .toRotationMatrix();
}

// Of the component before scale, rotation and move.
Bounds3 own_box(shape::Component component, const shape::MeshMemory& meshes) {
  component.scale = Vec3::Ones();
  component.rotate = component.at = Vec3::Zero();
  std::erase_if(component.operations, [](const shape::Operation& operation) {
    return !std::holds_alternative<shape::Cut>(operation);
  });
  shape::Program alone;
  alone.components = {std::move(component)};
  const auto shape = shape::evaluate(alone, {.tolerance = 0.01, .paint = false, .memory = &meshes});
  return shape ? shape::bounds(*shape) : Bounds3{};
}

bool stretch(shape::Component& component, const Handle& handle, double amount,
             const shape::MeshMemory& meshes) {
  const int axis = handle.axis;
  const Bounds3 box = own_box(component, meshes);
  if (box.empty()) return false;
  const double length = box.size()[axis] * std::abs(component.scale[axis]);
  if (length < 1e-4) return false;
  const double factor = 1.0 + amount / length;
  const double scale = component.scale[axis] * factor;
  if (!(factor >= least_factor && factor <= greatest_factor) || std::abs(scale) > greatest_scale)
    return false;
  const double fixed = box.low[axis] + handle.anchor * box.size()[axis];
  Vec3 shift = Vec3::Zero();
  shift[axis] = (component.scale[axis] - scale) * fixed;
  component.at += rotation(component) * shift;
  component.scale[axis] = scale;
  return true;
}

// The axis that stands upright keeps its scale.
bool widen(shape::Component& component, double amount) {
  const Eigen::Matrix3d turn = rotation(component);
  for (int axis = 0; axis < 3; ++axis) {
    const double upright = std::abs(turn(2, axis));
    if (upright > 0.02 && upright < 0.98) return false;
    if (upright <= 0.02) component.scale[axis] *= 1.0 + amount;
  }
  component.at.head<2>() *= 1.0 + amount;
  return component.scale.cwiseAbs().maxCoeff() <= greatest_scale;
}

bool pull_path(shape::Component& component, bool first, const Vec3& by) {
  auto* part = std::get_if<shape::SweptPart>(&component.solid);
  if (!part || part->path.closed || part->path.points.size() < 2) return false;
  auto& points = part->path.points;
  const double last = static_cast<double>(points.size() - 1);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double along = static_cast<double>(k) / last;
    points[k] += (first ? 1.0 - along : along) * by;
  }
  return true;
}

// Exactly a shift, without trying.
bool moves_plainly(const shape::Program& program, const ComponentPath& path) {
  if (path.size() != 1) return false;
  const auto& operations = program.components[path.front()].operations;
  return std::all_of(operations.begin(), operations.end(), [](const shape::Operation& operation) {
    return std::holds_alternative<shape::Cut>(operation) ||
           std::holds_alternative<shape::Array>(operation);
  });
}

double probe(const Handle& handle) {
  return handle.kind == Handle::Kind::move ? 0.01 : 0.002;
}

Vec3 position(const Assembly& assembly, const Wish& wish) {
  return assembly.parts()[wish.part].solid.mesh().positions[wish.vertex].cast<double>();
}

// The wishes' vertices' movement for each amount, one below the other.
std::optional<Eigen::MatrixXd> response(const Assembly& assembly, const Handle& handle,
                                        const std::vector<Wish>& wishes) {
  const auto rows = static_cast<Eigen::Index>(3 * wishes.size());
  Eigen::MatrixXd result(rows, handle.amounts());
  if (handle.kind == Handle::Kind::move && moves_plainly(assembly.program(), handle.path)) {
    for (Eigen::Index k = 0; k < rows; k += 3) result.middleRows(k, 3).setIdentity();
    return result;
  }
  const double step = probe(handle);
  for (int amount = 0; amount < handle.amounts(); ++amount) {
    Assembly trial = assembly;
    if (!pull(trial, handle, step * Eigen::VectorXd::Unit(handle.amounts(), amount)))
      return std::nullopt;
    for (std::size_t k = 0; k < wishes.size(); ++k) {
      const auto& before = assembly.parts()[wishes[k].part].solid.mesh();
      const auto& after = trial.parts()[wishes[k].part].solid.mesh();
      // A curve that is divided otherwise tells nothing.
      if (before.positions.size() != after.positions.size()) return std::nullopt;
      result.block<3, 1>(static_cast<Eigen::Index>(3 * k), amount) =
          (position(trial, wishes[k]) - position(assembly, wishes[k])) / step;
    }
  }
  return result;
}

}  // namespace

bool pull(Assembly& assembly, const Handle& handle, const Eigen::VectorXd& amounts) {
  if (!amounts.allFinite()) return false;
  shape::Program program;
  program.components = {assembly.program().components[handle.path.front()]};
  ComponentPath inside = handle.path;
  inside.front() = 0;
  shape::Component& component = component_at(program, inside);
  bool changed = true;
  switch (handle.kind) {
    case Handle::Kind::move:
      component.at += amounts;
      break;
    case Handle::Kind::stretch:
      changed = stretch(component, handle, amounts[0], assembly.meshes());
      break;
    case Handle::Kind::path_end:
      changed = pull_path(component, handle.first, amounts);
      break;
    case Handle::Kind::widen:
      changed = widen(component, amounts[0]);
      break;
  }
  if (!changed || component.at.cwiseAbs().maxCoeff() > shape::greatest_length) return false;
  return assembly.replace(handle.path.front(), program.components.front());
}

std::size_t nearest_vertex(const Part& part, const Vec3& point) {
  const auto& positions = part.solid.mesh().positions;
  std::size_t best = 0;
  double least = 1e300;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const double distance = (positions[k].cast<double>() - point).squaredNorm();
    if (distance < least) {
      least = distance;
      best = k;
    }
  }
  return best;
}

std::optional<Eigen::VectorXd> solve(const Assembly& assembly, const Handle& handle,
                                     const std::vector<Wish>& wishes) {
  const auto moved = response(assembly, handle, wishes);
  if (!moved || moved->norm() < 1e-6) return std::nullopt;
  Eigen::VectorXd wanted(moved->rows());
  for (std::size_t k = 0; k < wishes.size(); ++k)
    wanted.segment<3>(static_cast<Eigen::Index>(3 * k)) = wishes[k].move;
  if (handle.amounts() > 1) {
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> system(*moved);
    system.setThreshold(1e-3);
    return Eigen::VectorXd(system.solve(wanted));
  }
  // A stretch along a leaning axis goes as far as the wish reaches along its own direction.
  const double along = moved->col(0).dot(wanted);
  if (std::abs(along) < 0.4 * moved->norm() * wanted.norm()) return std::nullopt;
  return Eigen::VectorXd::Constant(1, wanted.squaredNorm() / along);
}

}  // namespace roomgen::create::detail
