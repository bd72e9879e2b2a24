#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// Writes a scene in a format of another program.
class Exporter {
 public:
  virtual ~Exporter() = default;

  /// Writes one file, whole or not at all. Equal scenes and models give equal bytes. Objects
  /// without a model are written as boxes.
  virtual Status write(const Scene& scene, const ModelTable& models,
                       const std::filesystem::path& path) const = 0;
};

/// A picture as the bytes of a file.
struct EncodedImage {
  std::string mime_type;  ///< "image/png" or "image/jpeg"
  std::string bytes;
};

/// How exporters make files of textures. The core links no image library: roomgen::render provides
/// one (render/pictures.h).
using ImageEncoder = std::function<Result<EncodedImage>(const Image&)>;

struct ExportOptions {
  ImageEncoder encode_image;  ///< without it textures become their mean colour
  bool lights = true;         ///< with the lamps and the sun
};

/// A format that scenes can be written in.
struct ExportFormat {
  std::string_view name;   ///< and the ending of its files: "glb"
  std::string_view about;  ///< for users
  std::unique_ptr<Exporter> (*make)(const ExportOptions& options);
};
/// Every format there is. A new one is an Exporter in src/export and a row of its formats.cpp.
std::span<const ExportFormat> export_formats();
/// Null if there is none of that name.
const ExportFormat* find_export_format(std::string_view name);

/// The scene as binary glTF 2.0 (Khronos specification 2.0.1): metres, Y up, fronts towards +Z.
///
/// Nodes: "room" with its floor, walls, ceiling, doors and windows as children, then one node an object, whose
/// extras hold id, category, size (width, depth, height), description, room and relations. Those of the room
/// itself have the extras id, category and "shell": true. One mesh an asset, shared by its objects; a node's
/// scale brings it to the object's size. Textures are embedded once. asset.copyright names creators and licences.
///
/// Names of nodes, meshes, materials and textures have letters and digits of ASCII, blanks, '-', '_' and '.'
/// only, at most 63 of them, and each stands once of its kind, also after three.js has made '_' of the blanks.
/// An object's node is called by its id, as far as that is such a name; programs may change it, and read_glb_nodes
/// (import/import.h) goes by the extras. A mesh is called by what it is of, and its asset_key() is in its
/// extras as "key"; a material that had another name has that in its extras as "name".
///
/// A node "lights" holds the lamps as point or spot lights, in candela, each named by its object, and the
/// sun that shines in as a directional one, in lux (extension KHR_lights_punctual; docs/materials.md).
Result<std::string> make_glb(const Scene& scene, const ModelTable& models,
                             const ExportOptions& options = {});

/// One model alone: a single node in the model's frame, called by this name as objects are by their ids, whose
/// extras hold its size.
Result<std::string> make_glb(const std::string& name, const Model& model,
                             const ExportOptions& options = {});

class GlbExporter final : public Exporter {
 public:
  explicit GlbExporter(ExportOptions options = {}) : options_(std::move(options)) {}
  Status write(const Scene& scene, const ModelTable& models,
               const std::filesystem::path& path) const override;

 private:
  ExportOptions options_;
};

/// ATTRIBUTION.md for a scene: every asset of a library once, with creator, licence and the objects,
/// doors and windows that use it. Things that roomgen made itself need none.
std::string attribution_markdown(const Scene& scene);

/// The same in one line, for files that have a field for it; empty if nothing needs it.
std::string attribution_line(const Scene& scene);

}  // namespace roomgen
