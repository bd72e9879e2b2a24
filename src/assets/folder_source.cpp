// A folder (or archive) of mesh files without a catalogue: each file is an asset named after
// itself, described by the JSON file of the same name if there is one.

#include "asset_source.h"
#include "decode/import_mesh.h"
#include "roomgen/base/text.h"
#include "sidecar.h"

namespace roomgen::assets {

namespace {

std::string without_extension(const std::string& name) {
  return name.substr(0, name.size() - extension_of(name).size() - 1);
}

// "oak_dining-table 2" reads as "oak dining table 2".
std::string name_from_file(const std::string& file) {
  std::string name = file_name_of(file);
  for (char& c : name)
    if (c == '_' || c == '-' || c == '.') c = ' ';
  return std::string(trim(name));
}

// What the formats say about their axes, or by custom: glTF is Y-up, front +Z, in metres; STL and
// PLY come from CAD, Z-up.
SourceFrame usual_frame(const std::string& extension) {
  SourceFrame frame;
  const bool z_up = extension == "stl" || extension == "ply";
  frame.ours_from_source = *ours_from_axes(z_up ? "+z" : "+y", z_up ? "-y" : "+z");
  if (extension == "glb" || extension == "gltf") frame.metres_per_unit = 1.0;
  return frame;
}

}  // namespace

std::vector<SourceAsset> list_folder(const FileTree& tree, const std::string& library,
                                     const LogSink& log) {
  std::vector<SourceAsset> assets;
  for (const auto& mesh : tree.names) {
    if (!decode::is_mesh_file(mesh)) continue;
    const std::string stem = without_extension(mesh);
    SourceAsset asset;
    asset.mesh = mesh;
    asset.frame = usual_frame(extension_of(mesh));
    asset.info.ref.library = library;
    // Two formats of one thing are two assets.
    const bool doubled = !assets.empty() && assets.back().info.ref.id == stem;
    asset.info.ref.id = doubled ? mesh : stem;
    asset.info.name = name_from_file(stem);
    if (const std::string sidecar = stem + ".json"; tree.contains(sidecar)) {
      const auto text = tree.read(sidecar);
      const Status applied = text ? apply_sidecar(*text, sidecar, asset) : Status(text.error());
      if (!applied) {
        roomgen::log(log, LogLevel::warning, applied.error().message + "; left out");
        continue;
      }
    }
    assets.push_back(std::move(asset));
  }
  return assets;
}

}  // namespace roomgen::assets
