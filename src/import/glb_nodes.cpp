#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "geometry/conventions.h"
#include "glb_file.h"
#include "roomgen/import/import.h"

namespace roomgen {

namespace {

using Eigen::Matrix4d;

constexpr std::size_t most_nodes = 200'000, longest_node_name = 1 << 20;
constexpr double furthest = 1e9;

// glTF 2.0, section 3.5.3: a matrix in the order of columns, or translation, rotation and scale.
Matrix4d transform_of(const JsonReader& node) {
  if (node["matrix"].exists()) {
    const auto values = node["matrix"].numbers(16, -furthest, furthest);
    return Eigen::Map<const Matrix4d>(values.data());
  }
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (node["translation"].exists()) {
    const auto t = node["translation"].numbers(3, -furthest, furthest);
    transform.translate(Vec3(t[0], t[1], t[2]));
  }
  if (node["rotation"].exists()) {
    const auto q = node["rotation"].numbers(4, -1.0001, 1.0001);
    Eigen::Quaterniond rotation(q[3], q[0], q[1], q[2]);
    if (rotation.norm() < 0.5) node["rotation"].report("is no unit quaternion");
    else transform.rotate(rotation.normalized());
  }
  if (node["scale"].exists()) {
    const auto s = node["scale"].numbers(3, -furthest, furthest);
    transform.scale(Vec3(s[0], s[1], s[2]));
  }
  return transform.matrix();
}

/// Walks the nodes from those that nothing is above of.
class NodeReader {
 public:
  NodeReader(const Json& gltf, JsonReader::Problems& problems) : root_(gltf, problems) {
    nodes_ = root_["nodes"].elements_or_none(most_nodes);
    for (const auto& node : nodes_) children_.push_back(children_of(node));
    const Eigen::Matrix3d turn = find_axis_convention("gltf")->theirs_from_ours;
    from_room_.topLeftCorner<3, 3>() = turn;
  }

  std::vector<SceneNode> read() {
    std::vector<bool> is_child(nodes_.size());
    for (const auto& children : children_)
      for (const std::size_t child : children) {
        if (is_child[child]) nodes_[child].report("has two nodes above it");
        is_child[child] = true;
      }
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (!is_child[i]) open_.push_back({i, Matrix4d::Identity()});
    std::size_t seen = 0;
    for (; !open_.empty() && seen <= nodes_.size(); ++seen) visit();
    if (seen != nodes_.size()) root_["nodes"].report("go in a circle");
    return std::move(found_);
  }

 private:
  struct Open {
    std::size_t node;
    Matrix4d above;
  };

  std::vector<std::size_t> children_of(const JsonReader& node) const {
    std::vector<std::size_t> children;
    for (const auto& child : node["children"].elements_or_none(most_nodes)) {
      const long long index = child.integer_or(-1, 0, static_cast<long long>(most_nodes));
      if (index >= 0 && static_cast<std::size_t>(index) < nodes_.size()) children.push_back(static_cast<std::size_t>(index));
      else child.report("names no node of the file");
    }
    return children;
  }

  // The room itself has ids of its own, which those of things may equal.
  static std::string id_of(const JsonReader& node) {
    const JsonReader extras = node["extras"];
    const bool is_shell = extras.is_object() && extras["shell"].exists();
    return is_shell ? std::string() : detail::text_in_extras(node, "id");
  }

  void visit() {
    const Open next = open_.back();
    open_.pop_back();
    const JsonReader& node = nodes_[next.node];
    const Matrix4d world = next.above * transform_of(node);
    const std::string name = node["name"].text_or("", longest_node_name), id = id_of(node);
    if (!name.empty() || !id.empty())
      found_.push_back({name, id, from_room_.inverse() * world * from_room_});
    for (const std::size_t child : children_[next.node]) open_.push_back({child, world});
  }

  JsonReader root_;
  std::vector<JsonReader> nodes_;
  std::vector<std::vector<std::size_t>> children_;
  Matrix4d from_room_ = Matrix4d::Identity();
  std::vector<Open> open_;
  std::vector<SceneNode> found_;
};

}  // namespace

Result<std::vector<SceneNode>> read_glb_nodes(const std::filesystem::path& path) {
  const auto file = detail::read_glb_file(path);
  if (!file) return file.error();
  JsonReader::Problems problems(path.string());
  auto nodes = NodeReader(file->json, problems).read();
  if (const auto& problem = problems.first()) return *problem;
  return nodes;
}

}  // namespace roomgen
