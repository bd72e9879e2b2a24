#pragma once

#include <memory>

#include "roomgen/base/file.h"
#include "roomgen/export/exporter.h"
#include "roomgen/generate/generate.h"
#include "roomgen/scene/scene.h"
#include "roomgen/view/view.h"

namespace roomgen::cli {

/// A renderer that is made when the first picture is wanted, and keeps what it has seen for the next.
class PictureDrawer {
 public:
  Result<Renderer*> renderer();

 private:
  std::unique_ptr<Renderer> renderer_;
};

/// With textures as they are.
ExportOptions export_options();

/// scene.glb, and ATTRIBUTION.md for the meshes in it.
Status write_model_files(const OutputFolder& folder, const Scene& scene, const ModelTable& models);

/// top.png, iso.png and eye.png.
Status write_pictures(const OutputFolder& folder, const Scene& scene, const ModelTable& models, Renderer& renderer,
                      int pixels);

/// All files of a new room: its documents, its model, and with a drawer its pictures.
Status write_new_room(const OutputFolder& folder, const Json& plan, const Generation& generation,
                      PictureDrawer* drawer, int pixels);

}  // namespace roomgen::cli
