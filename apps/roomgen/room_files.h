#pragma once

#include "roomgen/base/file.h"
#include "roomgen/scene/model_table.h"
#include "roomgen/scene/scene.h"
#include "roomgen/view/view.h"

namespace roomgen::cli {

/// scene.glb, and ATTRIBUTION.md for the meshes in it.
Status write_model_files(const OutputFolder& folder, const Scene& scene, const ModelTable& models);

/// top.png, iso.png and eye.png.
Status write_pictures(const OutputFolder& folder, const Scene& scene, const ModelTable& models, Renderer& renderer,
                      int pixels);

}  // namespace roomgen::cli
