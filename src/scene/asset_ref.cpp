#include "roomgen/scene/asset_ref.h"

namespace roomgen {

namespace {
constexpr long long max_seed = 9007199254740991;  // exact in a double
}

std::string asset_key(const AssetRef& asset) {
  if (asset.procedural)
    return "procedural:" + asset.procedural->recipe + ":" + asset.procedural->params.dump() + ":" +
           std::to_string(asset.procedural->seed);
  return asset.id.empty() ? std::string() : asset.library + "/" + asset.id;
}

Json to_json(const AssetRef& asset) {
  Json json = Json::object();
  if (asset.procedural) {
    json["procedural"] = {{"recipe", asset.procedural->recipe},
                          {"params", asset.procedural->params},
                          {"seed", asset.procedural->seed}};
  } else if (!asset.id.empty()) {
    json["library"] = asset.library;
    json["id"] = asset.id;
    json["sha256"] = asset.sha256;
    json["license"] = asset.license;
    json["creator"] = asset.creator;
  }
  return json;
}

AssetRef read_asset(const JsonReader& json) {
  AssetRef asset;
  if (!json.exists()) return asset;
  json.allow_only({"library", "id", "sha256", "license", "creator", "procedural"});
  asset.library = json["library"].text_or("");
  asset.id = json["id"].text_or("");
  asset.sha256 = json["sha256"].text_or("");
  asset.license = json["license"].text_or("");
  asset.creator = json["creator"].text_or("");
  if (const auto procedural = json["procedural"]; procedural.exists()) {
    procedural.allow_only({"recipe", "params", "seed"});
    ProceduralSource source;
    source.recipe = procedural["recipe"].text(200);
    if (const auto params = procedural["params"]; params.exists()) source.params = *params.raw();
    source.seed = static_cast<std::uint64_t>(procedural["seed"].integer_or(0, 0, max_seed));
    asset.procedural = source;
  }
  return asset;
}

}  // namespace roomgen
