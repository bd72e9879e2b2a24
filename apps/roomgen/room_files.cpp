#include "room_files.h"

#include <utility>

#include "made.h"
#include "roomgen/export/exporter.h"
#include "roomgen/render/pictures.h"

namespace roomgen::cli {

Status write_model_files(const OutputFolder& folder, const Scene& scene, const ModelTable& models) {
  if (auto status = folder.write("ATTRIBUTION.md", attribution_markdown(scene)); !status) return status;
  const auto place = folder.place_for("scene.glb");
  if (!place) return place.error();
  return GlbExporter(glb_options()).write(scene, models, *place);
}

Status write_pictures(const OutputFolder& folder, const Scene& scene, const ModelTable& models, Renderer& renderer,
                      int pixels) {
  const std::pair<View::Kind, const char*> views[] = {{View::Kind::top, "top.png"},
                                                      {View::Kind::isometric, "iso.png"},
                                                      {View::Kind::eye, "eye.png"}};
  for (const auto& [kind, name] : views) {
    View view;
    view.kind = kind;
    view.pixels = pixels;
    const auto image = renderer.render(scene, models, view);
    if (!image) return image.error();
    if (auto status = write_png(folder, name, *image); !status) return status;
  }
  return {};
}

}  // namespace roomgen::cli
