#pragma once

#include <string>

#include "roomgen/export/exporter.h"
#include "roomgen/export/image_encoder.h"
#include "roomgen/scene/room_shell.h"

namespace roomgen {

struct GlbOptions {
  ImageEncoder encode_image;  ///< without it textures become their mean colour
  ShellOptions shell;         ///< how the room itself is built
  bool lights = true;         ///< with the lamps and the sun
};

/// The scene as binary glTF 2.0 (Khronos specification 2.0.1): metres, Y up, fronts towards +Z.
///
/// Nodes: "room" with the parts of room_shell() as children, then one node an object, named by its
/// id, whose extras hold category, size (width, depth, height), description and relations. One mesh
/// an asset, shared by its objects; a node's scale brings it to the object's size. Textures are
/// embedded once. asset.copyright names creators and licences.
///
/// A node "lights" holds the lamps of lamp_lights() as point or spot lights, in candela, each named by
/// its object, and the sun of sunlight() as a directional one, in lux (extension KHR_lights_punctual).
Result<std::string> make_glb(const Scene& scene, const ModelTable& models,
                             const GlbOptions& options = {});

/// One model alone: a single node of this name in the model's frame, whose extras hold its size.
Result<std::string> make_glb(const std::string& name, const Model& model,
                             const GlbOptions& options = {});

class GlbExporter final : public Exporter {
 public:
  explicit GlbExporter(GlbOptions options = {}) : options_(std::move(options)) {}
  Status write(const Scene& scene, const ModelTable& models,
               const std::filesystem::path& path) const override;

 private:
  GlbOptions options_;
};

}  // namespace roomgen
