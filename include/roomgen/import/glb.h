#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "roomgen/base/result.h"
#include "roomgen/geometry/image.h"
#include "roomgen/scene/model_table.h"

namespace roomgen {

/// Makes a picture of the bytes of a PNG or JPEG file; the core links no image library.
using ImageDecoder = std::function<Result<Image>(std::string_view bytes)>;

/// The furniture in a scene.glb that roomgen wrote, as it was in its library, by asset_key(). Of glTF
/// it reads what the exporter writes (export/glb.h): triangles with indices in the file's own binary
/// chunk, and the metallic-roughness surface. Without a decoder textures are left out.
Result<ModelTable> read_glb_models(const std::filesystem::path& path,
                                   const ImageDecoder& decode = {});

}  // namespace roomgen
