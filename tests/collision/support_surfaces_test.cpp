#include "collision/support_surfaces.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/random.h"
#include "catch.h"
#include "roomgen/base/json.h"
#include "roomgen/geometry/model.h"
#include "roomgen/shape/evaluate.h"
#include "roomgen/shape/program.h"

using namespace roomgen;

namespace {

void add_box(Mesh& mesh, const Vec3& low, const Vec3& high) {
  append(mesh, make_box(low, high));
}

//   ________
//  |________|  0.72 to 0.75
//   |      |
Mesh table_mesh() {
  Mesh mesh;
  add_box(mesh, {-0.6, -0.4, 0.72}, {0.6, 0.4, 0.75});
  for (double x : {-0.57, 0.52})
    for (double y : {-0.37, 0.32}) add_box(mesh, {x, y, 0}, {x + 0.05, y + 0.05, 0.72});
  return mesh;
}

// Sides, a back, and boards every 0.3 m.
Mesh bookshelf(int boards) {
  Mesh mesh;
  const double height = 0.3 * (boards - 1) + 0.1;
  for (double x : {-0.4, 0.38}) add_box(mesh, {x, -0.15, 0}, {x + 0.02, 0.15, height});
  add_box(mesh, {-0.4, 0.14, 0}, {0.4, 0.15, height});
  for (int i = 0; i < boards; ++i)
    add_box(mesh, {-0.38, -0.15, 0.06 + 0.3 * i}, {0.38, 0.14, 0.08 + 0.3 * i});
  return mesh;
}

// Height over a square of 1 m, as an open sheet.
template <typename Height>
Mesh sheet(const Height& height, int cells = 40) {
  Mesh mesh;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const double x = static_cast<double>(i) / cells - 0.5, y = static_cast<double>(j) / cells - 0.5;
      mesh.positions.push_back(Vec3(x, y, height(x, y)).cast<float>());
    }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

Mesh ball(double radius) {
  Mesh mesh;
  constexpr int rings = 48;
  const auto point = [&](int i, int j) {
    const double a = pi * i / rings, b = 2 * pi * j / rings;
    return Vec3(radius * std::sin(a) * std::cos(b), radius * std::sin(a) * std::sin(b),
                radius * (1 - std::cos(a)));
  };
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < rings; ++j) {
      const auto k = static_cast<std::uint32_t>(mesh.positions.size());
      for (const auto& p : {point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)})
        mesh.positions.push_back(p.cast<float>());
      mesh.triangles.push_back({k, k + 2, k + 1});
      mesh.triangles.push_back({k, k + 3, k + 2});
    }
  return mesh;
}

void reverse_some(Mesh& mesh, Random& random, double share) {
  for (auto& t : mesh.triangles)
    if (random.chance(share)) std::swap(t[1], t[2]);
}

Mesh made(const std::string& recipe) {
  const std::filesystem::path folder = std::string(ROOMGEN_SOURCE_DIR) + "/data/shapes";
  const auto json = shape::read_recipe(folder / (recipe + ".json"));
  REQUIRE(json);
  const auto program = shape::instantiate(*json, {}, 0, shape::recipes_in(folder));
  REQUIRE(program);
  const auto shape = shape::evaluate(*program, {.paint = false});
  REQUIRE(shape);
  return merged_mesh(shape::to_model(*shape));
}

}  // namespace

TEST_CASE("A table has one surface: its top, open above") {
  const auto surfaces = support_surfaces(table_mesh());
  REQUIRE(surfaces.size() == 1);
  CHECK(surfaces[0].height == Approx(0.75).margin(1e-6));
  // The grid of 2 cm counts the cells on the border whole.
  CHECK(surfaces[0].area == Approx(0.96).epsilon(0.045));
  CHECK(surfaces[0].clearance == SupportSurface::open);
  CHECK(surfaces[0].at({0.59, 0.39}));
  CHECK_FALSE(surfaces[0].at({0.63, 0.0}));
}

TEST_CASE("Every board of a shelf is a surface with the height up to the next one") {
  const auto surfaces = support_surfaces(bookshelf(5));
  REQUIRE(surfaces.size() == 5);
  std::vector<double> heights;
  for (const auto& surface : surfaces) heights.push_back(surface.height);
  std::sort(heights.begin(), heights.end());
  for (int i = 0; i < 5; ++i) CHECK(heights[static_cast<std::size_t>(i)] == Approx(0.08 + 0.3 * i).margin(1e-6));
  for (const auto& surface : surfaces) {
    CHECK(surface.area == Approx(0.76 * 0.29).epsilon(0.12));
    if (surface.height < 1.0) CHECK(surface.clearance == Approx(0.28).margin(1e-6));
  }
}

TEST_CASE("The inside of a closed cabinet and the underside of a thick top carry nothing") {
  Mesh cabinet;
  add_box(cabinet, {-0.4, -0.2, 0.0}, {0.4, 0.2, 0.8});
  add_box(cabinet, {-0.38, -0.18, 0.4}, {0.38, 0.18, 0.42});
  const auto surfaces = support_surfaces(cabinet);
  REQUIRE(surfaces.size() == 1);
  CHECK(surfaces[0].height == Approx(0.8).margin(1e-6));
}

TEST_CASE("Balls and slopes carry nothing, gently curved tops do") {
  for (double radius : {0.1, 0.25, 0.5}) CHECK(support_surfaces(ball(radius)).empty());
  CHECK(support_surfaces(sheet([](double x, double) { return 0.5 + 0.4 * x; })).empty());
  const auto cushion = support_surfaces(
      sheet([](double x, double y) { return 0.45 - 0.05 * (std::pow(2 * x, 4) + std::pow(2 * y, 4)); }));
  REQUIRE(cushion.size() == 1);
  CHECK(cushion[0].area > 0.3);
}

TEST_CASE("Winding and small noise do not hide a surface") {
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    Mesh sheet_of_glass = sheet([&](double, double) { return 0.7 + 0.0004 * random.uniform(); });
    Mesh frame = table_mesh();
    reverse_some(sheet_of_glass, random, 0.5);
    reverse_some(frame, random, 1.0);
    CHECK(support_surfaces(sheet_of_glass).size() == 1);
    CHECK(support_surfaces(frame).front().height == Approx(0.75).margin(1e-6));
  }
}

TEST_CASE("Slats are one surface") {
  Mesh slats;
  for (int i = 0; i < 10; ++i)
    add_box(slats, {-0.5 + 0.1 * i, -0.4, 0.7}, {-0.5 + 0.1 * i + 0.085, 0.4, 0.72});
  const auto surfaces = support_surfaces(slats);
  REQUIRE(surfaces.size() == 1);
  CHECK(surfaces[0].box().size().x() > 0.9);
}

TEST_CASE("Cells lie on the mesh, and nothing is in the clearance above them") {
  for (const char* recipe : {"table", "desk", "bookshelf", "shelving", "bed", "sofa", "chair", "hutch"}) {
    const Mesh mesh = made(recipe);
    INFO(recipe);
    const auto surfaces = support_surfaces(mesh);
    REQUIRE_FALSE(surfaces.empty());
    double area = surfaces[0].area;
    for (const auto& surface : surfaces) {
      CHECK(surface.area <= area);
      area = surface.area;
      for (const auto& cell : surface.cells) {
        if (!cell.free) continue;
        CHECK(std::abs(cell.height - surface.height) <= 0.0251);
        CHECK(cell.clearance >= 0.05f);
      }
    }
  }
}

TEST_CASE("Tables have a surface at their top, shelves several") {
  for (const char* recipe : {"table", "desk", "workbench", "stool"}) {
    INFO(recipe);
    const Mesh mesh = made(recipe);
    const auto surfaces = support_surfaces(mesh);
    REQUIRE_FALSE(surfaces.empty());
    const bool at_top = std::any_of(surfaces.begin(), surfaces.end(), [&](const auto& surface) {
      return surface.height > bounds(mesh).high.z() - 0.05;
    });
    CHECK(at_top);
  }
  for (const char* recipe : {"bookshelf", "shelving"}) {
    INFO(recipe);
    CHECK(support_surfaces(made(recipe)).size() >= 3);
  }
}
