#include <string>

#include "render/overlay.h"
#include "roomgen/render/pictures.h"

namespace roomgen::lab {

namespace {

constexpr double arrow_length = 0.35;  // metres, of the direction of a view

Vec2 on_plan(const Camera& camera, const Vec2& place) { return camera.pixel({place.x(), place.y(), 0.0}); }

Drawing::Stroke way_of(const Tour& tour, const Camera& camera) {
  Drawing::Stroke way{Drawing::Line::outline, {}};
  for (const auto& keyframe : tour.keyframes) {
    const Vec2 pixel = on_plan(camera, keyframe.pose.eye.head<2>());
    if (way.points.empty() || (pixel - way.points.back()).norm() > 1.0) way.points.push_back(pixel);
  }
  return way;
}

// Where it is, where it looks, and its number.
void add_view(Drawing& drawing, const TourView& view, std::size_t number, const Camera& camera) {
  const Vec2 eye = view.pose.eye.head<2>(), ahead = front_direction(view.pose.yaw);
  const Vec2 from = on_plan(camera, eye);
  drawing.strokes.push_back({Drawing::Line::arrow, {from, on_plan(camera, eye + arrow_length * ahead)}});
  const std::string text = std::to_string(number);
  const Vec2 back = from - on_plan(camera, eye + ahead);
  const Vec2 size = label_size(text, drawing.text_height);
  drawing.labels.push_back({Drawing::Text::object, text, from + size.maxCoeff() * back.normalized(), size});
}

}  // namespace

Result<Image> tour_picture(Renderer& renderer, const Scene& scene, const ModelTable& models, const Tour& tour,
                           int pixels) {
  View plan;
  plan.pixels = pixels;
  const auto camera = make_camera(scene, plan);
  if (!camera) return camera.error();
  auto image = renderer.render(scene, models, plan);
  if (!image) return image;
  Drawing drawing;
  if (const auto way = way_of(tour, *camera); way.points.size() > 1) drawing.strokes.push_back(way);
  for (std::size_t k = 0; k < tour.views.size(); ++k) add_view(drawing, tour.views[k], k + 1, *camera);
  if (auto status = roomgen::detail::draw_overlay(*image, drawing); !status) return status.error();
  return image;
}

}  // namespace roomgen::lab
