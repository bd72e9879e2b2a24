#include "roomgen/render/pictures.h"

#include <algorithm>

#include "gl_context.h"
#include "picture.h"
#include "shadow_map.h"
#include "view/model_camera.h"

namespace roomgen {

namespace {

using namespace detail;

constexpr double model_shadow_width = 0.008;     // metres, of a shadow's soft edge
constexpr double floor_thickness = 0.002;  // thin: it must not hide anything in a level view

std::shared_ptr<const Model> floor_under(const Bounds3& box) {
  const double around = 0.2 * box.size().head<2>().norm() + 0.15 * box.size().z();
  const Vec3 low(box.low.x() - around, box.low.y() - around, box.low.z() - floor_thickness);
  const Vec3 high(box.high.x() + around, box.high.y() + around, box.low.z());
  auto model = std::make_shared<Model>();
  Material material;
  material.base_color = {0.78f, 0.77f, 0.75f, 1.0f};
  model->materials.push_back(material);
  model->parts.push_back({make_box(low, high), 0});
  return model;
}

std::vector<Vec3> corners(const Bounds3& box) {
  std::vector<Vec3> points;
  for (int k = 0; k < 8; ++k)
    points.push_back({k & 1 ? box.high.x() : box.low.x(), k & 2 ? box.high.y() : box.low.y(),
                      k & 4 ? box.high.z() : box.low.z()});
  return points;
}

}  // namespace

const std::vector<std::string>& model_view_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& view : model_views()) all.push_back(view.name);
    return all;
  }();
  return names;
}

Result<std::vector<Image>> draw_views(const Model& model, int pixels) {
  const GlTurn turn;
  auto context = GlContext::create();
  if (!context) return context.error();
  if (auto status = (*context)->make_current(); !status) return status.error();
  const auto& gl = (*context)->gl();
  auto painter = ScenePainter::create(gl);
  if (!painter) return painter.error();
  auto picture = Picture::create(gl);
  if (!picture) return picture.error();
  ShadowMap shadows(gl);
  GpuCache cache(gl);
  const Bounds3 box = bounds(model);
  const auto floor = floor_under(box);
  const DrawList items = {fixed_item("model", std::make_shared<Model>(model), cache),
                          fixed_item("floor", floor, cache)};

  Bounds3 all = items[1].box;
  all.add(box.high);
  const std::vector<Vec3> lit = corners(all);
  std::vector<Image> images;
  for (const auto& view : model_views()) {
    const Camera camera = model_camera(box, view, pixels);
    const Sun sun = make_sun(sun_direction(camera, View::Kind::isometric), lit);
    shadows.update(*painter, items, sun, ShadowMap::whole());
    Image image(camera.width, camera.height);
    auto status = picture->draw(*painter, items, camera, {&sun, shadows.texture(), model_shadow_width / sun.extent},
                                {0, 0, camera.width, camera.height}, false, image);
    if (!status) return status.error();
    images.push_back(std::move(image));
  }
  return images;
}

Image contact_sheet(const std::vector<Image>& pictures, int columns) {
  if (pictures.empty()) return {};
  const int width = pictures[0].width, height = pictures[0].height;
  const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
  Image sheet(columns * width, rows * height);
  std::fill(sheet.pixels.begin(), sheet.pixels.end(), std::uint8_t{255});
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    const int x = static_cast<int>(k) % columns * width, y = static_cast<int>(k) / columns * height;
    for (int row = 0; row < height; ++row)
      std::copy_n(pictures[k].at(0, row), 4 * width, sheet.at(x, y + row));
  }
  return sheet;
}

}  // namespace roomgen
