#include "roomgen/library/standins.h"

#include <Eigen/Geometry>
#include <map>

#include "catch.h"
#include "roomgen/library/vocabulary.h"

using namespace roomgen;

namespace {

AssetMatch build_for(const AssetQuery& query) {
  const auto matches = make_standins()->search(query);
  REQUIRE(matches);
  REQUIRE(matches->size() == 1);
  return matches->front();
}

using PointKey = std::array<float, 3>;

PointKey key(const Eigen::Vector3f& p) {
  return {p.x(), p.y(), p.z()};
}

// Every edge of a closed mesh is used once in each direction.
bool is_closed(const Mesh& mesh) {
  std::map<std::pair<PointKey, PointKey>, int> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const PointKey a = key(mesh.positions[t[i]]), b = key(mesh.positions[t[(i + 1) % 3]]);
      ++edges[{a, b}];
      --edges[{b, a}];
    }
  return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles)
    sum += mesh.positions[t[0]].cast<double>().dot(
               mesh.positions[t[1]].cast<double>().cross(mesh.positions[t[2]].cast<double>())) /
           6.0;
  return sum;
}

bool normals_follow_winding(const Mesh& mesh) {
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f face = (mesh.positions[t[1]] - mesh.positions[t[0]])
                                     .cross(mesh.positions[t[2]] - mesh.positions[t[0]]);
    for (const auto v : t)
      if (mesh.normals[v].dot(face) < 0.0f || std::abs(mesh.normals[v].norm() - 1.0f) > 1e-3f)
        return false;
  }
  return true;
}

}  // namespace

TEST_CASE("Every recipe fills its box with closed meshes that face outward") {
  const auto mount = GENERATE(Mount::floor, Mount::wall, Mount::ceiling);
  const auto size = GENERATE(Vec3(0.9, 0.4, 1.8), Vec3(0.3, 0.3, 0.2), Vec3(2.0, 1.2, 0.05));
  for (const auto& recipe : standin_recipes()) {
    INFO(recipe << " " << size.transpose());
    const Model model = build_standin({recipe, size, mount, "white", 7});
    REQUIRE_FALSE(model.parts.empty());
    const Bounds3 box = bounds(model);
    CHECK((box.size() - size).norm() < 1e-5);
    CHECK(std::abs(box.low.z()) < 1e-6);
    CHECK(box.center().head<2>().norm() < 1e-5);
    for (const auto& part : model.parts) {
      CHECK(is_closed(part.mesh));
      CHECK(volume(part.mesh) > 0.0);
      CHECK(normals_follow_winding(part.mesh));
      CHECK(part.mesh.uvs.size() == part.mesh.positions.size());
    }
  }
}

TEST_CASE("A stand-in has the wanted size and knows what it is") {
  const auto match = build_for({.category = "wall mirror", .size = Vec3(0.7, 0.03, 1.1)});
  CHECK(match.asset.category == "mirror");
  CHECK(match.asset.size.isApprox(Vec3(0.7, 0.03, 1.1), 1e-9));
  CHECK(match.asset.mount == Mount::wall);
  REQUIRE(match.asset.ref.procedural);
  CHECK(match.asset.ref.procedural->recipe == "mirror");
}

TEST_CASE("A stand-in is loaded from its reference alone") {
  const auto match = build_for({.category = "console table", .description = "walnut"});
  const auto model = make_standins()->load(match.asset.ref);
  REQUIRE(model);
  CHECK((bounds(**model).size() - match.asset.size).norm() < 1e-5);
  CHECK(match.asset.colors == std::vector<std::string>{"walnut"});
  CHECK(match.asset.triangles == triangle_count(**model));
}

TEST_CASE("Storage of any sort is a box with a lid") {
  for (const auto* category : {"chest", "toy box", "laundry hamper", "wicker basket"})
    CHECK(build_for({.category = category}).asset.ref.procedural->recipe == "box");
}

TEST_CASE("Other kinds get no stand-in") {
  for (const auto* category : {"sofa", "vacuum cleaner", "bookend", "pool table", "", "dog bed"}) {
    INFO(category);
    const auto matches = make_standins()->search({.category = category});
    REQUIRE(matches);
    CHECK(matches->empty());
  }
}

TEST_CASE("A stand-in is not hung where its kind cannot hang") {
  const auto matches = make_standins()->search({.category = "rug", .mount = Mount::ceiling});
  REQUIRE(matches);
  CHECK(matches->empty());
}

TEST_CASE("Broken params of a scene file still build something") {
  AssetRef ref;
  ref.procedural = ProceduralSource{"table", {{"size", "large"}, {"mount", 3}}, 1};
  CHECK(make_standins()->load(ref));
  ref.procedural->recipe = "castle";
  CHECK_FALSE(make_standins()->load(ref));
}
