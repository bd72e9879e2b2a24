#include "roomgen/library/library.h"

namespace roomgen {

ModelTable load_models(const Scene& scene, const AssetLibrary& library, const LogSink& log_sink,
                       const SpareModels& spare) {
  ModelTable models;
  const auto add = [&](const std::string& owner, const AssetRef& asset) {
    const std::string key = asset_key(asset);
    if (key.empty() || models.find(key)) return;
    auto model = library.load(asset);
    if (model) return models.add(key, *std::move(model));
    if (auto other = spare ? spare(key) : nullptr)
      models.add(key, std::move(other));
    else
      log(log_sink, LogLevel::warning, owner + ": " + model.error().message);
  };
  for (const auto& room : rooms_of(scene))
    for (const auto& opening : room.openings) add(opening.id, opening.joinery.asset);
  for (const auto& object : scene.objects) add(object.id, object.asset);
  return models;
}

}  // namespace roomgen
