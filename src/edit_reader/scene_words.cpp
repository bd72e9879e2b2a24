#include "scene_words.h"

#include <nlohmann/json.hpp>

#include "design/scene_text.h"
#include "edit_words.h"

namespace roomgen {

SceneWords words_of_scene(const Scene& scene) {
  SceneWords words;
  for (const auto& part : parts_of(scene)) {
    const design::SceneText text(part.room, false);
    const std::string heading = part.room.id.empty() ? "" : part.room.id + ":\n";
    words.room += (words.room.empty() ? "" : "; ") + text.room();
    words.parts += heading + text.parts();
    words.placed += heading + text.placed(part.objects);
  }
  return words;
}

Result<Prompts::Slots> operation_slots(const Prompts& prompts, const Scene& scene) {
  auto words = prompts.render("place-words", {});
  if (!words) return words.error();
  auto operations = prompts.render("edit-operations", {});
  if (!operations) return operations.error();
  auto shapes = prompts.render("create-generate-system", {});
  if (!shapes) return shapes.error();
  const design::SceneText first(rooms_of(scene).front(), false);
  return Prompts::Slots{{"frame", first.frame()},
                        {"words", *std::move(words)},
                        {"operations", *std::move(operations)},
                        {"shapes", *std::move(shapes)}};
}

Json operations_schema(const std::string& remark) {
  const Json operation = {{"type", "object"}, {"required", {"do"}}, {"properties", {{"do", {{"type", "string"}}}}}};
  Json schema = {{"type", "object"}, {"required", {"operations"}}};
  schema["properties"]["operations"] = {{"type", "array"}, {"items", operation}};
  schema["properties"][remark] = {{"type", "string"}};
  return schema;
}

}  // namespace roomgen
