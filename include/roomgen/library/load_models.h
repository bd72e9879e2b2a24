#pragma once

#include <functional>
#include <memory>
#include <string>

#include "roomgen/base/log.h"
#include "roomgen/base/result.h"
#include "roomgen/library/library.h"
#include "roomgen/scene/model_table.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// Where else a mesh may come from, by asset_key(); null if not from there either.
using SpareModels = std::function<std::shared_ptr<const Model>(const std::string& key)>;

/// The meshes of all objects and openings of a scene. An asset that neither the library has (any more)
/// nor `spare` is reported to `log`; its objects stay boxes, its openings keep the room's own woodwork.
ModelTable load_models(const Scene& scene, const AssetLibrary& library, const LogSink& log = {},
                       const SpareModels& spare = {});

}  // namespace roomgen
