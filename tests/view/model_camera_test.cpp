#include "view/model_camera.h"

#include <Eigen/Geometry>

#include "catch.h"

using namespace roomgen;

TEST_CASE("Every view of a thing shows all of it, in one scale") {
  for (const Vec3& size :
       {Vec3(2, 0.9, 0.8), Vec3(0.1, 0.1, 2), Vec3(3, 2, 0.01), Vec3(0.02, 1, 0.02)}) {
    Bounds3 box;
    box.add(Vec3(1, -2, 0));
    box.add(Vec3(1, -2, 0) + size);
    for (const auto& view : model_views()) {
      const Camera camera = model_camera(box, view, 512);
      INFO(view.name << " of " << size.transpose());
      CHECK(camera.pixels_per_metre == model_camera(box, model_views()[0], 512).pixels_per_metre);
      CHECK(camera.right.cross(camera.up).isApprox(camera.backward));
      for (int k = 0; k < 8; ++k) {
        const Vec3 p(k & 1 ? box.high.x() : box.low.x(), k & 2 ? box.high.y() : box.low.y(),
                     k & 4 ? box.high.z() : box.low.z());
        const Vec2 pixel = camera.pixel(p);
        CHECK((pixel.minCoeff() > 0 && pixel.maxCoeff() < 512));
        CHECK((camera.depth(p) < camera.near && camera.depth(p) > camera.far));
      }
    }
  }
}

TEST_CASE("The front view looks at the front, the side view at the left side") {
  Bounds3 box;
  box.add(Vec3(-1, -1, 0));
  box.add(Vec3(1, 1, 1));
  CHECK(model_camera(box, model_views()[0], 64).backward.isApprox(Vec3(0, -1, 0)));
  // Left as a person sitting in it would say.
  CHECK(model_camera(box, model_views()[1], 64).backward.isApprox(Vec3(1, 0, 0)));
  CHECK(model_camera(box, model_views()[2], 64).backward.isApprox(Vec3(0, 1, 0)));
  CHECK(model_camera(box, model_views()[3], 64).backward.z() == Approx(0.5));
}
