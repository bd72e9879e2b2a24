#include "numbered_shell.h"

#include <algorithm>

#include "geometry/alpha.h"
#include "shown.h"

namespace roomgen::detail {

namespace {

// Layers show no colours: textures matter where they have holes.
Model without_paint(Model model) {
  for (auto& material : model.materials)
    if (alpha_mode(material) == AlphaMode::opaque) material.texture.reset();
  return model;
}

}  // namespace

void NumberedShell::update(std::span<const Room> rooms, const ModelTable& models, const View& view,
                           const Camera& camera) {
  const std::string key = shell_key(rooms, view, camera);
  if (key == key_) return;
  key_ = key;
  parts_.clear();
  for (auto& part : shown_shell(rooms, models, view, camera))
    parts_.push_back({part.name, std::make_shared<Model>(without_paint(std::move(part.model)))});
}

void NumberedShell::append_items(std::span<const LayerThing> things, std::size_t first, GpuCache& cache,
                                 std::vector<NumberedItem>& items) const {
  for (const auto& part : parts_) {
    const auto thing = std::find_if(things.begin(), things.end(),
                                    [&](const LayerThing& one) { return one.id == part.id; });
    if (thing == things.end()) continue;
    const auto number = first + static_cast<std::size_t>(thing - things.begin());
    items.push_back({fixed_item(part.id + " of " + key_, part.model, cache), static_cast<std::uint16_t>(number)});
  }
}

}  // namespace roomgen::detail
