#include "assembly.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <unordered_map>

namespace roomgen::create::detail {

namespace {

// Coarser than what is shown: gaps of millimetres stay what they are on flat and straight parts.
constexpr double tolerance = 0.003;
// More triangles than this say nothing more about contacts.
constexpr std::size_t enough_triangles = 60'000;
// A corner or the tip of a cone has less surface within 2 mm of a plane; thin wires more.
constexpr double point_area = 1.5e-5;
constexpr double thick = 0.012, deep = 0.006;

struct Mass {
  double volume = 0.0;
  Vec3 centroid = Vec3::Zero();
};

// Tetrahedra over the middle of the box, which keeps the numbers small.
Mass mass_of(const Mesh& mesh, const Vec3& origin) {
  Mass mass;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]].cast<double>() - origin;
    const Vec3 b = mesh.positions[t[1]].cast<double>() - origin;
    const Vec3 c = mesh.positions[t[2]].cast<double>() - origin;
    const double part = a.dot(b.cross(c)) / 6.0;
    mass.volume += part;
    mass.centroid += part * (a + b + c) / 4.0;
  }
  if (mass.volume > 1e-12)
    mass.centroid = mass.centroid / mass.volume + origin;
  else
    mass.centroid = origin;
  mass.volume = std::max(mass.volume, 0.0);
  return mass;
}

struct PairHash {
  std::size_t operator()(const std::pair<std::uint64_t, std::uint64_t>& pair) const {
    return static_cast<std::size_t>(pair.first * 0x9e3779b97f4a7c15ull ^ pair.second);
  }
};
template <typename Value>
using ByPair = std::unordered_map<std::pair<std::uint64_t, std::uint64_t>, Value, PairHash>;

}  // namespace

struct Assembly::Memory {
  std::uint64_t next_id = 1, work = 0;
  ByPair<bool> touching, pointed;
  ByPair<NearestPoints> nearest;
  shape::MeshMemory meshes;

  shape::EvaluateOptions coarse() const { return {tolerance, false, &meshes}; }
  Part part(shape::Body body) {
    work += body.mesh.triangles.size() * 2;
    const Bounds3 box = bounds(body.mesh);
    const Mass mass = mass_of(body.mesh, box.empty() ? Vec3(Vec3::Zero()) : box.center());
    body.mesh.normals.clear();
    body.mesh.uvs.clear();
    return {std::move(body.name),
            std::move(body.label),
            std::move(body.source),
            MeshSolid(std::move(body.mesh)),
            mass.volume,
            mass.centroid,
            next_id++};
  }
};

shape::Component& component_at(shape::Program& program, const ComponentPath& path) {
  shape::Component* component = &program.components[path.front()];
  for (std::size_t k = 1; k < path.size(); ++k)
    component = &std::get<shape::Group>(component->solid).components[path[k]];
  return *component;
}

const shape::Component& component_at(const shape::Program& program, const ComponentPath& path) {
  return component_at(const_cast<shape::Program&>(program), path);
}

bool starts_with(const ComponentPath& path, const ComponentPath& prefix) {
  return prefix.size() <= path.size() && std::equal(prefix.begin(), prefix.end(), path.begin());
}

Result<Assembly> Assembly::make(const shape::Program& program, double contact) {
  auto memory = std::make_shared<Memory>();
  auto shape = shape::evaluate_within(program, enough_triangles, memory->coarse());
  if (!shape) return shape.error();
  Assembly assembly;
  assembly.program_ = program;
  assembly.contact_ = contact;
  assembly.memory_ = std::move(memory);
  for (auto& body : shape->bodies)
    if (!body.mesh.triangles.empty())
      assembly.parts_.push_back(assembly.memory_->part(std::move(body)));
  if (assembly.parts_.empty())
    return Error{Error::Kind::invalid_input, "the program makes no solid"};
  return assembly;
}

Assembly Assembly::of(const shape::Shape& shape, double contact) {
  Assembly assembly;
  assembly.contact_ = contact;
  assembly.memory_ = std::make_shared<Memory>();
  for (const auto& body : shape.bodies)
    if (!body.mesh.triangles.empty()) assembly.parts_.push_back(assembly.memory_->part(body));
  return assembly;
}

bool Assembly::replace(std::size_t top, const shape::Component& component) {
  shape::Program alone;
  alone.components = {component};
  auto shape = shape::evaluate_within(alone, enough_triangles, memory_->coarse());
  memory_->work += 100;
  if (!shape) return false;
  const auto first = std::find_if(parts_.begin(), parts_.end(),
                                  [&](const Part& part) { return part.source.front() == top; });
  const auto last = std::find_if(first, parts_.end(),
                                 [&](const Part& part) { return part.source.front() != top; });
  std::erase_if(shape->bodies, [](const shape::Body& body) { return body.mesh.triangles.empty(); });
  if (static_cast<std::size_t>(last - first) != shape->bodies.size()) return false;
  auto part = first;
  for (auto& body : shape->bodies) {
    body.source.front() = top;
    *part++ = memory_->part(std::move(body));
  }
  program_.components[top] = component;
  return true;
}

const shape::MeshMemory& Assembly::meshes() const {
  return memory_->meshes;
}

bool Assembly::touch(std::size_t a, std::size_t b) const {
  const Part &first = parts_[std::min(a, b)], &second = parts_[std::max(a, b)];
  if (box_distance(first.box(), second.box()) > contact_) return false;
  const auto [known, is_new] = memory_->touching.try_emplace({first.id, second.id}, false);
  if (!is_new) return known->second;
  memory_->work += 200;
  known->second = within(first.solid, second.solid, contact_);
  return known->second;
}

bool Assembly::touch_in_a_point(std::size_t a, std::size_t b) const {
  if (!touch(a, b)) return false;
  const Part &first = parts_[std::min(a, b)], &second = parts_[std::max(a, b)];
  if (std::min(first.box().size().minCoeff(), second.box().size().minCoeff()) < thick) return false;
  // What reaches deep into the other's box is more than its tip.
  const Vec3 shared =
      first.box().high.cwiseMin(second.box().high) - first.box().low.cwiseMax(second.box().low);
  if (shared.minCoeff() > deep) return false;
  const auto [known, is_new] = memory_->pointed.try_emplace({first.id, second.id}, false);
  if (!is_new) return known->second;
  memory_->work += 400;
  const AreaOptions some = {.enough = point_area};
  known->second = contact_area(first.solid, second.solid, contact_, some) < point_area ||
                  contact_area(second.solid, first.solid, contact_, some) < point_area;
  return known->second;
}

NearestPoints Assembly::nearest(std::size_t a, std::size_t b) const {
  if (b < a) {
    NearestPoints other = nearest(b, a);
    std::swap(other.on_a, other.on_b);
    return other;
  }
  const auto [known, is_new] = memory_->nearest.try_emplace({parts_[a].id, parts_[b].id});
  if (is_new) {
    memory_->work += 400;
    known->second = nearest_points(parts_[a].solid, parts_[b].solid).value_or(NearestPoints{});
  }
  return known->second;
}

std::vector<std::vector<std::size_t>> Assembly::contacts() const {
  // Along x, so that hundreds of parts are not compared each with each.
  std::vector<std::size_t> order(parts_.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const double left = parts_[a].box().low.x(), right = parts_[b].box().low.x();
    return left < right || (left == right && a < b);
  });
  std::vector<std::vector<std::size_t>> result(parts_.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    for (std::size_t m = k + 1; m < order.size(); ++m) {
      const std::size_t a = order[k], b = order[m];
      if (parts_[b].box().low.x() > parts_[a].box().high.x() + contact_) break;
      if (!touch(a, b)) continue;
      result[a].push_back(b);
      result[b].push_back(a);
    }
  memory_->work += parts_.size();
  return result;
}

std::uint64_t Assembly::work() const {
  return memory_->work;
}

}  // namespace roomgen::create::detail
