#pragma once

#include "roomgen/base/log.h"
#include "roomgen/base/result.h"
#include "roomgen/library/library.h"
#include "roomgen/scene/model_table.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// The meshes of all objects of a scene. An asset that the library does not have (any more) is reported
/// to `log` and its objects stay boxes.
ModelTable load_models(const Scene& scene, const AssetLibrary& library, const LogSink& log = {});

}  // namespace roomgen
