#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "roomgen/base/file.h"
#include "roomgen/base/result.h"
#include "roomgen/export/exporter.h"
#include "roomgen/geometry/model.h"
#include "roomgen/view/view.h"

namespace roomgen {

/// Draws with OpenGL in main memory (OSMesa): no window, display or graphics card is needed.
///
/// A renderer keeps the meshes, textures and last pictures it has seen, so that the next picture of
/// a room draws only what changed. One thread at a time may use it; several renderers may be used by
/// several threads, and take turns: OSMesa draws one picture of a process at a time, with threads of its
/// own. Fails with Error::Kind::unavailable when OSMesa gives no OpenGL 4.0 core context.
Result<std::unique_ptr<Renderer>> make_osmesa_renderer();

/// A model alone on a plain floor, without a room: square pictures of one scale, `pixels` wide, in the
/// order of model_view_names(). Needs what make_osmesa_renderer() needs.
Result<std::vector<Image>> draw_views(const Model& model, int pixels = 512);
/// "front", "side" (its left), "back" and "above" (three-quarter).
const std::vector<std::string>& model_view_names();

/// Pictures of one size side by side, `columns` in a row.
Image contact_sheet(const std::vector<Image>& pictures, int columns);

/// A room from above as a plan of segments, for who reads pictures rather than numbers: every category in a colour
/// of its own, the ids of things, walls, doors and windows written on them, coordinates beside the room, a legend and
/// a scale. `pixels` on the longer side; ids are readable from 700 on.
Result<Image> segmentation_picture(Renderer& renderer, const Scene& scene, const ModelTable& models,
                                   int pixels = 1024);

// Pictures as files.

/// PNG (ISO/IEC 15948): RGB if the picture is opaque, else RGBA. `effort` is zlib's level, 0 to 9.
Result<std::string> encode_png(const Image& image, int effort = 3);
/// Baseline JPEG of an opaque picture; quality 1 to 100.
Result<std::string> encode_jpeg(const Image& image, int quality = 90);
/// An ImageEncoder for exporters: JPEG for opaque textures, PNG for small ones and those with
/// alpha.
Result<EncodedImage> encode_texture(const Image& image);

Status write_png(const std::filesystem::path& path, const Image& image);
/// The same into a folder of results; `name` is relative to it.
Status write_png(const OutputFolder& folder, const std::filesystem::path& name, const Image& image);

/// Layers as files NAME.png, NAME.depth.png … and NAME.json (docs/layers.md).
Status write_layers(const OutputFolder& folder, const std::string& name, const Layers& layers);

}  // namespace roomgen
