#include "roomgen/library/load_models.h"

namespace roomgen {

ModelTable load_models(const Scene& scene, const AssetLibrary& library, const LogSink& log_sink) {
  ModelTable models;
  for (const auto& object : scene.objects) {
    const std::string key = asset_key(object.asset);
    if (key.empty() || models.find(key)) continue;
    auto model = library.load(object.asset);
    if (model) models.add(key, *std::move(model));
    else log(log_sink, LogLevel::warning, object.id + ": " + model.error().message);
  }
  return models;
}

}  // namespace roomgen
