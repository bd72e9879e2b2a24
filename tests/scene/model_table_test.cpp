#include "roomgen/scene/scene.h"

#include "catch.h"
#include "scene/box_model.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

Model cylinder(const Vec3& size) {
  Object object = rooms::thing("a-0", "thing", size);
  object.traits.round = true;
  return box_model(object);
}

Model box(const Vec3& low, const Vec3& high) {
  Model model;
  model.materials.emplace_back();
  model.parts = {{make_box(low, high), 0}};
  return model;
}

}  // namespace

TEST_CASE("Cylinders keep to their ellipse at any size, boxes and what is off its middle do not") {
  const Model can = cylinder({0.5, 0.5, 1});
  CHECK(keeps_to_ellipse(can, {0.5, 0.5, 1}));
  CHECK(keeps_to_ellipse(can, {2.0, 0.3, 1}));
  const Model crate = box({-0.2, -0.2, 0}, {0.2, 0.2, 1});
  CHECK_FALSE(keeps_to_ellipse(crate, {0.4, 0.4, 1}));
  CHECK(keeps_to_ellipse(crate, {0.02, 0.02, 1}));  // out by a millimetre or two
}

TEST_CASE("One leg that leaves the ellipse is enough, a centimetre is not") {
  const auto with_leg = [](double reach) {
    Model model = cylinder({1, 1, 0.5});
    const double at = reach * std::sqrt(0.5);
    model.parts.push_back({make_box({at - 0.01, at - 0.01, 0}, {at, at, 0.5}), 0});
    return model;
  };
  CHECK(keeps_to_ellipse(with_leg(0.49), {1, 1, 0.5}));
  CHECK(keeps_to_ellipse(with_leg(0.505), {1, 1, 0.5}));
  CHECK_FALSE(keeps_to_ellipse(with_leg(0.53), {1, 1, 0.5}));
}
