#pragma once

#include <filesystem>

#include "roomgen/base/result.h"
#include "roomgen/scene/model_table.h"
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

}  // namespace roomgen
