#include "portrait.h"

#include <algorithm>

#include "roomgen/render/pictures.h"

namespace roomgen::cli {

Status write_portrait(const AssetInfo& info, std::shared_ptr<const Model> model, int pixels,
                      const std::filesystem::path& path) {
  Scene scene;
  const double side = std::max(0.5, 1.3 * info.size.head<2>().maxCoeff());
  scene.room.polygon.points = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  scene.room.height = 1.2 * info.size.z() + 0.1;
  Object object;
  object.id = "asset";
  object.asset = info.ref;
  object.size = info.size;
  object.position = {0.5 * side, 0.5 * side, info.mount == Mount::wall ? 0.05 * side : 0.0};
  if (info.mount == Mount::wall) object.position.y() = side - 0.5 * info.size.y();
  scene.objects.push_back(object);
  ModelTable models;
  models.add(asset_key(info.ref), std::move(model));

  auto renderer = make_osmesa_renderer();
  if (!renderer) return renderer.error();
  View view;
  view.kind = View::Kind::isometric;
  view.pixels = pixels;
  const auto image = (*renderer)->render(scene, models, view);
  if (!image) return image.error();
  return write_png(path, *image);
}

}  // namespace roomgen::cli
