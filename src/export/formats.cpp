#include <algorithm>

#include "roomgen/export/exporter.h"

namespace roomgen {

namespace {

template <typename Format>
std::unique_ptr<Exporter> make(const ExportOptions& options) {
  return std::make_unique<Format>(options);
}

constexpr ExportFormat formats[] = {
    {"glb", "binary glTF 2.0: meshes, textures and lights", make<GlbExporter>},
};

}  // namespace

std::span<const ExportFormat> export_formats() {
  return formats;
}

const ExportFormat* find_export_format(std::string_view name) {
  const auto found = std::find_if(std::begin(formats), std::end(formats),
                                  [&](const ExportFormat& format) { return format.name == name; });
  return found == std::end(formats) ? nullptr : found;
}

}  // namespace roomgen
