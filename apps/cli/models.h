#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>

#include "command.h"
#include "roomgen/library/library.h"
#include "roomgen/scene/scene.h"
#ifdef ROOMGEN_HAS_ASSETS
#include "libraries.h"
#endif

namespace roomgen::cli {

/// Where a command that reads scenes finds their meshes. A build without furniture libraries has no
/// options and no meshes: objects are boxes.
struct ModelOptions {
#ifdef ROOMGEN_HAS_ASSETS
  LibraryOptions libraries;
#endif
};

void add_model_options(CLI::App& command, ModelOptions& options);

/// Meshes from the scene.glb beside a scene's file, which is read when the first is asked for.
SpareModels written_models(const std::filesystem::path& scene_file);

/// The meshes of a scene. What the libraries do not have is taken from the scene.glb beside the
/// scene's file; what is not there either is told on stderr and stays a box.
Result<ModelTable> models_of(const Scene& scene, const std::filesystem::path& file,
                             const ModelOptions& options, const Context& context);

}  // namespace roomgen::cli
