#include "rule_steps.h"

#include <random>

#include "catch.h"
#include "create/kinds.h"
#include "part_forms.h"
#include "parts.h"
#include "roomgen/create/create.h"
#include "roomgen/create/maker.h"
#include "roomgen/shape/program.h"

using namespace roomgen;
using namespace roomgen::create;

namespace {

const PartForms& part_forms() {
  REQUIRE(built_in_parts());
  return *built_in_parts();
}

PartWish wish(const std::string& label, int count) {
  PartWish part;
  part.label = label;
  part.count = count;
  return part;
}

Result<CreatedObject> made_of(const std::vector<PartWish>& parts, const std::string& kind = "") {
  Description description;
  description.prompt = description.noun = "thing";
  description.kind = kind;
  description.parts = parts;
  const auto maker = make_rule_maker();
  return create_described(description, *maker, {});
}

int bodies_called(const CreatedObject& object, const std::string& label) {
  return static_cast<int>(std::count_if(object.shape.bodies.begin(), object.shape.bodies.end(),
                                        [&](const auto& body) { return body.label == label; }));
}

// Edges of the mesh by positions, each of which a closed mesh has as often in one direction as in
// the other.
bool is_closed(const Mesh& mesh) {
  using Point = std::array<float, 3>;
  const auto point = [&](int index) {
    const auto& p = mesh.positions[static_cast<std::size_t>(index)];
    return Point{p.x(), p.y(), p.z()};
  };
  std::map<std::pair<Point, Point>, int> edges;
  for (const auto& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const Point a = point(static_cast<int>(triangle[k])), b = point(static_cast<int>(triangle[(k + 1) % 3]));
      if (a < b) ++edges[{a, b}];
      else --edges[{b, a}];
    }
  return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

}  // namespace

TEST_CASE("Forms of parts are closed and fill the box that they are told") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> side(0.3, 1.5);
  for (const auto& [label, part] : part_forms().parts) {
    for (int trial = 0; trial < 3; ++trial) {
      Vec3 size = part.size.cwiseProduct(Vec3(side(random), side(random), side(random)));
      double least = 1e9;
      for (const char axis : part.same) least = std::min(least, size[axis - 'x']);
      for (const char axis : part.same) size[axis - 'x'] = least;
      INFO(label << ", " << part.form << " " << size.transpose());
      const auto program = shape::instantiate(
          part_forms().forms.at(part.form),
          {{"width", size.x()}, {"depth", size.y()}, {"height", size.z()}}, 0, nullptr, part.form);
      REQUIRE(program);
      const auto shape = shape::evaluate(*program);
      REQUIRE(shape);
      const Bounds3 box = bounds(*shape);
      for (const auto& body : shape->bodies) CHECK(is_closed(body.mesh));
      // Drawn forms leave a part of the box free or swing out of it a little.
      for (int axis = 0; axis < 3; ++axis) {
        CHECK(box.size()[axis] > 0.2 * size[axis]);
        CHECK(box.size()[axis] < 1.5 * size[axis] + 0.02);
      }
      CHECK(std::abs(box.low.z()) < 0.3 * size.z() + 0.02);
    }
  }
}

TEST_CASE("Whatever part a thing is made of is there as often as it was asked for") {
  for (const auto& [label, form] : part_forms().parts) {
    for (const int count : {1, 2, 4, 7}) {
      INFO(count << " " << label);
      const auto object = made_of({wish(label, count)});
      REQUIRE(object);
      const int there = std::max(count_parts(object->program, label), bodies_called(*object, label));
      CHECK(there == count);
      CHECK(object->soundness.pieces == 1);
      CHECK(object->soundness.grounded);
    }
  }
}

TEST_CASE("Parts that a recipe does not know are added to what it makes") {
  for (const std::string kind : {"stool", "dining table", "bookcase", "armchair", "wardrobe"}) {
    const auto known = ShapeKinds::built_in()->labels(ShapeKinds::built_in()->find(kind)->recipe);
    for (const std::string label : {"gear", "branch", "star", "roof", "bell", "blade", "spike", "wing"}) {
      if (known.count(label)) continue;
      INFO(kind << " with three of " << label);
      const auto object = made_of({wish(label, 3)}, kind);
      REQUIRE(object);
      CHECK(bodies_called(*object, label) == 3);
      CHECK(object->soundness.pieces == 1);
      CHECK(object->soundness.grounded);
    }
  }
}

TEST_CASE("Things of several unlike parts hold together") {
  std::vector<std::string> labels;
  for (const auto& [label, form] : part_forms().parts) labels.push_back(label);
  std::mt19937 random(11);
  int whole = 0, stable = 0;
  constexpr int trials = 120;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<PartWish> parts;
    std::string said;
    for (int k = 0; k < 4; ++k) {
      parts.push_back(wish(labels[random() % labels.size()], 1 + static_cast<int>(random() % 4)));
      said += std::to_string(*parts.back().count) + " " + parts.back().label + ", ";
    }
    INFO(said);
    const auto object = made_of(parts);
    REQUIRE(object);
    CHECK(object->soundness.grounded);
    whole += object->soundness.pieces == 1;
    stable += object->soundness.stable;
  }
  CHECK(whole >= 0.95 * trials);
  CHECK(stable >= 0.9 * trials);
  WARN(whole << " of " << trials << " are one piece, " << stable << " stable");
}
