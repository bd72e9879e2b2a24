#pragma once

#include "roomgen/base/log.h"
#include "roomgen/base/result.h"
#include "roomgen/library/library.h"
#include "roomgen/scene/model_table.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// The meshes of all objects and openings of a scene. An asset that the library does not have (any more)
/// is reported to `log`; its objects stay boxes, its openings keep the room's own woodwork.
ModelTable load_models(const Scene& scene, const AssetLibrary& library, const LogSink& log = {});

}  // namespace roomgen
