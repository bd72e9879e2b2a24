#include "surfaces.h"

#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_map>

namespace roomgen::create {

namespace {

constexpr double same_point = 1e-6;  // metres; seams of normals and textures are no gaps

class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t member) {
    while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
    return member;
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

 private:
  std::vector<std::size_t> parent_;
};

using Cell = std::array<long long, 3>;

// For each vertex the first one in its place.
std::vector<std::size_t> welded(const Mesh& mesh) {
  std::map<Cell, std::size_t> first;
  std::vector<std::size_t> result(mesh.positions.size());
  for (std::size_t k = 0; k < result.size(); ++k) {
    const Vec3 position = mesh.positions[k].cast<double>() / same_point;
    const Cell place = {std::llround(position.x()), std::llround(position.y()),
                         std::llround(position.z())};
    result[k] = first.emplace(place, k).first->second;
  }
  return result;
}

// Triangles that share an edge are of one surface.
std::vector<std::size_t> surface_of_triangles(const Mesh& mesh) {
  const auto vertex = welded(mesh);
  Sets sets(mesh.triangles.size());
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> first;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::size_t a = vertex[mesh.triangles[t][static_cast<std::size_t>(k)]];
      const std::size_t b = vertex[mesh.triangles[t][static_cast<std::size_t>((k + 1) % 3)]];
      const auto [known, is_new] = first.emplace(std::minmax(a, b), t);
      if (!is_new) sets.join(t, known->second);
    }
  std::vector<std::size_t> result(mesh.triangles.size());
  for (std::size_t t = 0; t < result.size(); ++t) result[t] = sets.root(t);
  return result;
}

std::vector<Mesh> separated(const Mesh& mesh) {
  const auto surface = surface_of_triangles(mesh);
  std::map<std::size_t, std::size_t> index;
  for (const std::size_t root : surface) index.emplace(root, index.size());
  if (index.size() == 1) return {mesh};
  std::vector<Mesh> result(index.size());
  std::vector<std::unordered_map<std::uint32_t, std::uint32_t>> moved(index.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::size_t at = index[surface[t]];
    Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = mesh.triangles[t][k];
      const auto next = static_cast<std::uint32_t>(result[at].positions.size());
      const auto [known, is_new] = moved[at].emplace(from, next);
      if (is_new) result[at].positions.push_back(mesh.positions[from]);
      triangle[k] = known->second;
    }
    result[at].triangles.push_back(triangle);
  }
  return result;
}

}  // namespace

shape::Shape separate_surfaces(const shape::Shape& shape) {
  shape::Shape result;
  for (const auto& body : shape.bodies)
    for (auto& mesh : separated(body.mesh))
      result.bodies.push_back({body.name, body.label, std::move(mesh), body.material, body.source});
  return result;
}

}  // namespace roomgen::create
