#include "room_files.h"

#include <utility>

#include "roomgen/render/pictures.h"

namespace roomgen::cli {

Result<Renderer*> PictureDrawer::renderer() {
  if (!renderer_) {
    auto made = make_osmesa_renderer();
    if (!made) return made.error();
    renderer_ = *std::move(made);
  }
  return renderer_.get();
}

ExportOptions export_options() {
  ExportOptions options;
  options.encode_image = encode_texture;
  return options;
}

Status write_model_files(const OutputFolder& folder, const Scene& scene, const ModelTable& models) {
  if (auto status = folder.write("ATTRIBUTION.md", attribution_markdown(scene)); !status) return status;
  return folder.write_with("scene.glb", [&](const std::filesystem::path& now) {
    return GlbExporter(export_options()).write(scene, models, now);
  });
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

Status write_new_room(const OutputFolder& folder, const Json& plan, const Generation& generation,
                      PictureDrawer* drawer, int pixels) {
  if (auto status = write_documents(folder, plan, generation); !status) return status;
  if (auto status = write_model_files(folder, generation.scene, generation.models); !status) return status;
  if (!drawer) return {};
  const auto renderer = drawer->renderer();
  if (!renderer) return renderer.error();
  return write_pictures(folder, generation.scene, generation.models, **renderer, pixels);
}

}  // namespace roomgen::cli
