#pragma once

#include <string>

#include "roomgen/base/json.h"
#include "roomgen/chat/chat_model.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// A scene as a model that changes it is told of it: each room by itself, in a dwelling under its name.
struct SceneWords {
  std::string room, parts, placed;
};
SceneWords words_of_scene(const Scene& scene);

/// What its prompts say of coordinates, operations and relations.
Result<Prompts::Slots> operation_slots(const Prompts& prompts, const Scene& scene);

/// {"operations": [...], REMARK: "..."}
Json operations_schema(const std::string& remark);

}  // namespace roomgen
