#include <Eigen/Geometry>
#include <string>

#include "camera.h"

namespace roomgen {

namespace {

constexpr double nearest_shown = 0.05, farthest_shown = 100.0;  // metres before the eye
const double narrowest_view = radians(1.0), widest_view = radians(170.0);

Error bad_camera(const std::string& what) {
  return {Error::Kind::invalid_input, "camera: " + what};
}

// Straight up or down, the top of the picture is towards +Y.
Vec3 level_right(const Vec3& forward) {
  const Vec3 right = forward.cross(Vec3::UnitZ());
  return right.norm() > 1e-9 ? Vec3(right.normalized()) : Vec3(Vec3::UnitX());
}

}  // namespace

Vec2 Camera::pixel(const Vec3& point) const {
  const Vec3 offset = eye ? Vec3(point - *eye) : point;
  const double scale = eye ? -1.0 / backward.dot(offset) : 1.0;
  return {0.5 * width + pixels_per_metre * (scale * right.dot(offset) - center.x()),
          0.5 * height - pixels_per_metre * (scale * up.dot(offset) - center.y())};
}

Vec3 Camera::origin() const {
  return eye ? *eye : Vec3(center.x() * right + center.y() * up + near * backward);
}

Status check_picture_side(int pixels) {
  if (pixels >= min_picture_pixels && pixels <= max_picture_pixels) return {};
  return Error{Error::Kind::invalid_input,
               "a picture must be " + std::to_string(min_picture_pixels) + " to " +
                   std::to_string(max_picture_pixels) + " pixels long, not " + std::to_string(pixels)};
}

Status check_camera(const Camera& camera) {
  for (const int side : {camera.width, camera.height})
    if (auto status = check_picture_side(side); !status) return status;
  Eigen::Matrix3d axes;
  axes << camera.right, camera.up, camera.backward;
  if (!axes.isUnitary(1e-6) || axes.determinant() < 0)
    return bad_camera("right, up and backward must be unit vectors at right angles, right-handed");
  if (!(camera.pixels_per_metre > 0) || !camera.center.allFinite() || (camera.eye && !camera.eye->allFinite()))
    return bad_camera("its scale and its place must be finite");
  if (!(camera.near > camera.far) || (camera.eye && !(camera.depth(*camera.eye) > camera.near)))
    return bad_camera("near must lie between the eye and far");
  return {};
}

Result<Camera> pinhole_camera(const Vec3& eye, const Vec3& target, double angle, int width, int height) {
  for (const int side : {width, height})
    if (auto status = check_picture_side(side); !status) return status.error();
  if (!eye.allFinite() || !target.allFinite() || (target - eye).norm() < 1e-6)
    return bad_camera("the eye and what it looks at must be two points");
  if (!(angle >= narrowest_view && angle <= widest_view))
    return bad_camera("it must see 1 to 170 degrees from side to side");
  const Vec3 forward = (target - eye).normalized();
  Camera camera;
  camera.width = width;
  camera.height = height;
  camera.eye = eye;
  camera.right = level_right(forward);
  camera.up = camera.right.cross(forward);
  camera.backward = -forward;
  camera.pixels_per_metre = 0.5 * width / std::tan(0.5 * angle);
  camera.near = camera.depth(eye) - nearest_shown;
  camera.far = camera.depth(eye) - farthest_shown;
  return camera;
}

}  // namespace roomgen
