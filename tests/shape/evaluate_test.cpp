#include "roomgen/shape/evaluate.h"

#include <Eigen/Geometry>

#include "roomgen/shape/primitives.h"
#include "shape_files.h"
#include "support/contains.h"

using namespace roomgen;
using namespace roomgen::shape;

namespace {

Shape shape_of(const std::string& components) {
  return made(concrete(document(components)));
}

void require_sound(const Shape& shape) {
  for (const auto& body : shape.bodies) {
    INFO(body.name);
    CHECK(is_closed(body.mesh));
    CHECK(volume(body.mesh) > 0);
    for (const auto& n : body.mesh.normals) CHECK(n.norm() == Approx(1).margin(1e-3));
  }
}

// The mean over the triangles of the cosine between a vertex's normal and its face's.
double outwardness(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f face = (mesh.positions[t[1]] - mesh.positions[t[0]])
                                     .cross(mesh.positions[t[2]] - mesh.positions[t[0]])
                                     .normalized();
    for (const auto v : t) sum += face.dot(mesh.normals[v]) / 3;
  }
  return sum / static_cast<double>(mesh.triangles.size());
}

const std::string prism = R"("prism": {"sides": 3, "radius": 0.2, "height": 0.3})";

}  // namespace

TEST_CASE("A component is scaled, turned about X, Y, Z and moved, in this order") {
  const auto plain = shape_of("{\"name\": \"a\", " + prism + "}");
  const auto placed =
      shape_of("{\"name\": \"a\", " + prism +
               R"(, "at": [1, 2, 3], "rotate": [30, -40, 75], "scale": [1, 2, -0.5]})");
  const auto& before = plain.bodies[0].mesh.positions;
  const auto& after = placed.bodies[0].mesh.positions;
  REQUIRE(before.size() == after.size());
  const double a = radians(30), b = radians(-40), c = radians(75);
  for (std::size_t k = 0; k < before.size(); ++k) {
    Vec3 p = before[k].cast<double>().cwiseProduct(Vec3(1, 2, -0.5));
    p = Vec3(p.x(), p.y() * std::cos(a) - p.z() * std::sin(a),
             p.y() * std::sin(a) + p.z() * std::cos(a));
    p = Vec3(p.x() * std::cos(b) + p.z() * std::sin(b), p.y(),
             -p.x() * std::sin(b) + p.z() * std::cos(b));
    p = Vec3(p.x() * std::cos(c) - p.y() * std::sin(c), p.x() * std::sin(c) + p.y() * std::cos(c),
             p.z());
    CHECK((after[k].cast<double>() - p - Vec3(1, 2, 3)).norm() < 1e-5);
  }
  require_sound(placed);
  CHECK(outwardness(placed.bodies[0].mesh) ==
        Approx(outwardness(plain.bodies[0].mesh)).margin(0.01));
  CHECK(volume(placed.bodies[0].mesh) == Approx(volume(plain.bodies[0].mesh)).epsilon(1e-3));
}

TEST_CASE("Mirrors and negative scales keep bodies closed and outward") {
  for (const char* more :
       {R"("scale": -1)", R"("scale": [1, -2, 1])", R"("operations": [{"mirror": "x"}])",
        R"("operations": [{"mirror": "y"}, {"mirror": "x"}], "scale": [-1, 1, 1])"}) {
    const auto shape = shape_of(
        R"({"name": "a", "lathe": {"profile": [[0, 0], [0.1, 0], [0.2, 0.2], [0, 0.3]], "corners": [0, 1, 3], "angle": 200}, "at": [0.5, 0.6, 0], )" +
        std::string(more) + "}");
    INFO(more);
    require_sound(shape);
    for (const auto& body : shape.bodies) CHECK(outwardness(body.mesh) > 0.9);
  }
}

TEST_CASE("A mirror adds the mirror image in the parent's frame") {
  const auto shape =
      shape_of("{\"name\": \"a\", " + prism +
               R"(, "at": [1, 0.5, 0], "rotate": [0, 0, 20], "operations": [{"mirror": "x"}]})");
  REQUIRE(shape.bodies.size() == 2);
  CHECK(shape.bodies[0].name == "a-0");
  CHECK(shape.bodies[1].name == "a-1");
  for (std::size_t k = 0; k < shape.bodies[0].mesh.positions.size(); ++k) {
    const auto& p = shape.bodies[0].mesh.positions[k];
    CHECK((shape.bodies[1].mesh.positions[k] - Eigen::Vector3f(-p.x(), p.y(), p.z())).norm() <
          1e-6f);
  }
}

TEST_CASE("Radial copies divide a whole turn evenly and a part of it from end to end") {
  const auto angles = [](const std::string& radial) {
    std::vector<double> result;
    for (
        const auto& body :
        shape_of(
            R"({"name": "a", "box": {"size": [0.1, 0.1, 0.1]}, "at": [1, 0, 0], "operations": [{"radial": )" +
            radial + "}]}")
            .bodies) {
      const Vec3 c = bounds(body.mesh).center();
      CHECK(c.head<2>().norm() == Approx(1).margin(1e-5));
      result.push_back(degrees(std::atan2(c.y(), c.x())));
    }
    return result;
  };
  const auto whole = angles(R"({"count": 3, "start": 10})");
  REQUIRE(whole.size() == 3);
  CHECK(whole[0] == Approx(10).margin(0.01));
  CHECK(whole[1] == Approx(130).margin(0.01));
  CHECK(whole[2] == Approx(-110).margin(0.01));
  const auto part = angles(R"({"count": 3, "angle": 90})");
  CHECK(part[2] == Approx(90).margin(0.01));
}

TEST_CASE("Operations act on everything so far, in their order") {
  const auto twelve = shape_of(
      R"({"name": "a", "box": {"size": [0.1, 0.1, 0.1]}, "at": [0.5, 0.5, 3], "operations": [{"array": {"count": 3, "step": [0.2, 0, 0]}}, {"mirror": "x"}, {"mirror": "y"}, {"ground": true}]})");
  CHECK(twelve.bodies.size() == 12);
  CHECK(twelve.bodies[11].name == "a-11");
  CHECK(bounds(twelve).low.z() == Approx(0).margin(1e-6));
  CHECK(bounds(twelve).high.x() == Approx(0.95).margin(1e-5));
  const auto centred = shape_of(
      R"({"name": "a", "box": {"size": [0.1, 0.1, 0.1]}, "at": [5, 5, 5], "operations": [{"array": {"count": 3, "step": [0.2, 0, 0]}}, {"center": "xz"}]})");
  CHECK((bounds(centred).center() - Vec3(0, 5.0, 0)).norm() < 1e-5);
}

TEST_CASE("Joined copies are one body, later copies are copies of the whole") {
  const auto shape = shape_of(
      R"({"name": "a", "label": "leg", "box": {"size": [0.1, 0.1, 0.1]}, "operations": [{"array": {"count": 3, "step": [0.2, 0, 0]}}, {"join": true}, {"array": {"count": 2, "step": [0, 1, 0]}}]})");
  REQUIRE(shape.bodies.size() == 2);
  CHECK(shape.bodies[1].name == "a-1");
  CHECK(volume(shape.bodies[0].mesh) == Approx(0.003).epsilon(1e-3));
}

TEST_CASE("A cut acts in the component's own frame, before its transform") {
  const auto shape = shape_of(
      R"({"name": "a", "box": {"size": [1, 1, 1]}, "rotate": [0, 90, 0], "operations": [{"mirror": "x"}, {"cut": {"point": [0, 0, 0.25], "normal": [0, 0, 1]}}]})");
  REQUIRE(shape.bodies.size() == 2);
  require_sound(shape);
  CHECK(bounds(shape.bodies[0].mesh).high.x() == Approx(0.25).margin(1e-5));
  CHECK(bounds(shape.bodies[1].mesh).low.x() == Approx(-0.25).margin(1e-5));
}

TEST_CASE("Bodies know their names, labels, materials and source") {
  auto json = document(
      R"({"name": "top", "box": {"size": [1, 1, 1]}},
         {"name": "drawer", "label": "drawer", "material": "m", "at": [0, 0, 1], "operations": [{"array": {"count": 2, "step": [0, 0, 1]}}],
          "group": {"components": [{"name": "front", "box": {"size": [1, 0.1, 1]}},
                                   {"name": "knob", "label": "handle", "ellipsoid": {"size": [0.1, 0.1, 0.1]}, "material": "n", "at": [0.2, 0, 0], "operations": [{"mirror": "x"}]}]}})");
  json["materials"]["n"] = {{"color", "steel"}};
  const auto shape = made(concrete(json));
  REQUIRE(shape.bodies.size() == 7);
  CHECK(shape.bodies[0].label == "top");
  CHECK(shape.bodies[1].name == "drawer-0.front");
  CHECK(shape.bodies[1].label == "drawer");
  CHECK(shape.bodies[1].source == std::vector<std::size_t>{1, 0});
  CHECK(shape.bodies[1].material == 0);
  CHECK(shape.bodies[6].name == "drawer-1.knob-1");
  CHECK(shape.bodies[6].label == "handle");
  CHECK(shape.bodies[6].source == std::vector<std::size_t>{1, 1});
  CHECK(shape.bodies[6].material == 1);
  CHECK(shape.bodies[0].material == 2);  // plain
}

TEST_CASE("The model stands on the origin, one part a material") {
  const auto shape = made(concrete(shape_file("bar-stool")));
  const auto model = to_model(shape);
  CHECK(model.parts.size() == 2);
  const auto box = bounds(model);
  CHECK(box.low.z() == Approx(0).margin(1e-6));
  CHECK(box.center().head<2>().norm() < 1e-5);
  CHECK(triangle_count(model) == triangle_count(shape));
  CHECK((bounds(shape).size() - Vec3(0.4, 0.4, 0.72)).cwiseAbs().maxCoeff() < 1e-3);
}

TEST_CASE("Colours become linear, patterns carry them, equal ones share an image") {
  auto json = document(
      R"({"name": "a", "box": {"size": [1, 1, 1]}, "material": "m"}, {"name": "b", "box": {"size": [1, 1, 1]}, "material": "n"},
                          {"name": "c", "box": {"size": [1, 1, 1]}, "material": "o"})");
  json["materials"]["m"] = {{"color", "#808080"}, {"opacity", 0.5}};
  json["materials"]["n"] = {{"color", "oak"}, {"pattern", "grain"}};
  json["materials"]["o"] = {
      {"color", "oak"}, {"pattern", "grain"}, {"roughness", 0.1}, {"scale", 2}};
  const auto shape = made(concrete(json));
  CHECK(shape.materials[0].base_color[0] == Approx(linear_from_srgb(128)));
  CHECK(shape.materials[0].base_color[3] == 0.5f);
  CHECK(shape.materials[0].texture == nullptr);
  REQUIRE(shape.materials[1].texture);
  CHECK(shape.materials[1].texture == shape.materials[2].texture);
  CHECK(shape.materials[1].base_color[0] == 1.0f);
  CHECK((shape.bodies[1].mesh.uvs[1] - 2.0f * shape.bodies[2].mesh.uvs[1]).norm() < 1e-5f);
}

TEST_CASE("Textures are painted where they show, and for who wants them") {
  auto json = document(R"({"name": "a", "box": {"size": [1, 1, 1]}, "material": "n"})");
  json["materials"]["n"] = {{"color", "oak"}, {"pattern", "grain"}};
  json["materials"]["o"] = {{"color", "oak"}, {"pattern", "marble"}};
  const auto program = concrete(json);
  const auto shape = made(program);
  REQUIRE(shape.materials.size() == 3);
  CHECK(shape.materials[1].texture);
  CHECK_FALSE(shape.materials[2].texture);
  const auto plain = evaluate(program, {.paint = false});
  REQUIRE(plain);
  CHECK_FALSE(plain->materials[1].texture);
  CHECK(plain->materials[1].base_color[0] < 1.0f);
}

TEST_CASE("Remembered meshes are those that would be made") {
  const MeshMemory memory;
  for (const auto& name : shape_names) {
    const auto program = concrete(shape_file(name), {}, 9);
    const auto first = made(program);
    for (int round = 0; round < 2; ++round) {
      const auto again = evaluate(program, {.paint = false, .memory = &memory});
      REQUIRE(again);
      REQUIRE(again->bodies.size() == first.bodies.size());
      CHECK((bounds(*again).size() - bounds(first).size()).norm() < 0.003);
    }
  }
}

TEST_CASE("A picture is painted once, on the whole front") {
  const auto shape = shape_of(
      R"({"name": "a", "picture": {"size": [0.6, 0.4], "theme": "clock"}, "material": "m", "operations": [{"array": {"count": 2, "step": [1, 0, 0]}}]})");
  REQUIRE(shape.bodies.size() == 2);
  CHECK(shape.bodies[0].material == shape.bodies[1].material);
  REQUIRE(shape.materials[shape.bodies[0].material].texture);
  require_sound(shape);
}

TEST_CASE("A height field's formula is evaluated, and its faults are told") {
  const auto shape = shape_of(
      R"({"name": "a", "height_field": {"size": [2, 2], "height": "0.2 + 0.1 * u", "divisions": 4}})");
  CHECK(bounds(shape).high.z() == Approx(0.3).margin(1e-5));
  require_sound(shape);
  const auto broken = evaluate(
      concrete(document(R"({"name": "a", "height_field": {"size": [2, 2], "height": "1 / (u + 1) "
}
})")));
  REQUIRE_FALSE(broken);
  CHECK(contains_text(broken.error().message, "component \"a\": \"height\": column"));
}

TEST_CASE("Errors of solids name the component, and nothing is an error too") {
  const auto crossed = evaluate(concrete(document(
      R"({"name": "g", "group": {"components": [{"name": "x", "extrude": {"outline": [[0, 0], [1, 1], [1, 0], [0, 1]], "corners": "all", "height": 0.1}}]}})")));
  REQUIRE_FALSE(crossed);
  CHECK(contains_text(crossed.error().message, "component \"g.x\""));
  CHECK_FALSE(evaluate(Program{}));
  CHECK_FALSE(evaluate(concrete(shape_file("vase")), 0.0));
  CHECK_FALSE(evaluate(concrete(shape_file("vase")), std::nan("")));
}

TEST_CASE("Too many triangles are refused before they are copied, fewer are made when asked") {
  const auto program = concrete(document(
      R"({"name": "a", "ellipsoid": {"size": [1, 1, 1]}, "operations": [{"array": {"count": 4000, "step": [0.001, 0, 0]}}]})"));
  const auto refused = evaluate(program);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().kind == Error::Kind::limit);
  CHECK(contains_text(refused.error().message, "component \"a\": more than 500000 triangles"));

  const auto balls = concrete(document(
      R"({"name": "a", "ellipsoid": {"size": [1, 1, 1]}, "operations": [{"array": {"count": 20, "step": [1, 0, 0]}}]})"));
  const auto fine = evaluate(balls), coarse = evaluate_within(balls, 20000);
  REQUIRE((fine && coarse));
  CHECK(triangle_count(*fine) > 20000);
  CHECK(triangle_count(*coarse) <= 20000);
  CHECK(evaluate_within(balls, 1));
}

TEST_CASE("Equal programs give equal meshes") {
  for (const auto& name : shape_names) {
    const auto first = made(concrete(shape_file(name), {}, 9)),
               second = made(concrete(shape_file(name), {}, 9));
    REQUIRE(first.bodies.size() == second.bodies.size());
    for (std::size_t k = 0; k < first.bodies.size(); ++k) {
      CHECK(first.bodies[k].mesh.positions == second.bodies[k].mesh.positions);
      CHECK(first.bodies[k].mesh.uvs == second.bodies[k].mesh.uvs);
    }
    require_sound(first);
  }
}
