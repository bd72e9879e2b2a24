#include "roomgen/scene/object.h"

#include <charconv>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "document_parts.h"
#include "file_limits.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr std::size_t longest_finish = 200;

std::string written_parameters(const ProceduralSource& source) {
  return source.params.empty() ? "null" : source.params;
}

Json parsed_parameters(const ProceduralSource& source) {
  auto json = parse_json(written_parameters(source), source.recipe);
  return json ? *std::move(json) : Json();
}

}  // namespace

Json tilt_json(const Vec2& tilt) {
  return Json::array({rounded(degrees(tilt.x())), rounded(degrees(tilt.y()))});
}

Vec2 read_tilt(const JsonReader& json) {
  if (!json.exists()) return Vec2::Zero();
  const auto angles = json.numbers(2, -180.0, 180.0);
  return {radians(angles[0]), radians(angles[1])};
}

std::string text_parameter(const ProceduralSource& source, std::string_view name) {
  const Json params = parsed_parameters(source);
  const auto found = params.is_object() ? params.find(std::string(name)) : params.end();
  return found != params.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::string asset_key(const AssetRef& asset) {
  std::string key = asset.id.empty() ? std::string() : asset.library + "/" + asset.id;
  if (asset.procedural)
    key = "procedural:" + asset.procedural->recipe + ":" + written_parameters(*asset.procedural) + ":" +
          std::to_string(asset.procedural->seed);
  for (const auto& [stuff, looks] : asset.finish) key += "#" + stuff + "=" + looks;
  if (!key.empty() && !asset.tilt.isZero()) key += "#tilt=" + json_line(tilt_json(asset.tilt));
  if (!key.empty() && asset.wires > 0.0) key += "#wires=" + format_number(asset.wires, 4);
  return key;
}

std::optional<ProceduralSource> source_of_key(std::string_view key) {
  constexpr std::string_view prefix = "procedural:";
  if (!key.starts_with(prefix)) return std::nullopt;
  key.remove_prefix(prefix.size());
  const auto first = key.find(':'), last = key.rfind(':');
  if (first == last) return std::nullopt;
  ProceduralSource source{std::string(key.substr(0, first)),
                          std::string(key.substr(first + 1, last - first - 1))};
  if (source.params == written_parameters({})) source.params.clear();
  const auto digits = key.substr(last + 1);
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), source.seed);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return source;
}

Json to_json(const AssetRef& asset) {
  Json json = Json::object();
  if (asset.procedural) {
    json["procedural"] = {{"recipe", asset.procedural->recipe},
                          {"params", parsed_parameters(*asset.procedural)},
                          {"seed", asset.procedural->seed}};
  } else if (!asset.id.empty()) {
    json["library"] = asset.library;
    json["id"] = asset.id;
    json["sha256"] = asset.sha256;
    json["license"] = asset.license;
    json["creator"] = asset.creator;
  }
  for (const auto& [stuff, looks] : asset.finish) json["finish"][stuff] = looks;
  if (!asset.tilt.isZero()) json["tilt"] = tilt_json(asset.tilt);
  if (asset.wires > 0.0) json["wires"] = rounded(asset.wires);
  return json;
}

AssetRef read_asset(const JsonReader& json) {
  AssetRef asset;
  if (!json.exists()) return asset;
  json.allow_only(
      {"library", "id", "sha256", "license", "creator", "procedural", "finish", "tilt", "wires"});
  asset.library = json["library"].text_or("");
  asset.id = json["id"].text_or("");
  asset.sha256 = json["sha256"].text_or("");
  asset.license = json["license"].text_or("");
  asset.creator = json["creator"].text_or("");
  asset.tilt = read_tilt(json["tilt"]);
  asset.wires = json["wires"].number_or(0.0, 0.0, 0.99);
  if (const auto finish = json["finish"]; finish.exists())
    for (const auto& [stuff, looks] : finish.members()) asset.finish[stuff] = looks.text(longest_finish);
  if (const auto procedural = json["procedural"]; procedural.exists()) {
    procedural.allow_only({"recipe", "params", "seed"});
    ProceduralSource source;
    source.recipe = procedural["recipe"].text(200);
    if (const auto params = procedural["params"]; params.exists()) source.params = params.raw()->dump();
    source.seed = static_cast<std::uint64_t>(procedural["seed"].integer_or(0, 0, max_seed));
    asset.procedural = source;
  }
  return asset;
}

}  // namespace roomgen
