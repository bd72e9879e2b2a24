#include "sidecar.h"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/json_reader.h"
#include "roomgen/base/json.h"

namespace roomgen::assets {

namespace {

constexpr double largest_side = 50.0;  // metres

double metres_per_unit(const JsonReader& json, double fallback) {
  if (!json.exists()) return fallback;
  if (json.raw()->is_number()) return json.number(1e-6, 1e6);
  static constexpr std::array<std::pair<std::string_view, double>, 5> units = {
      {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"ft", 0.3048}}};
  const std::string text = json.text();
  for (const auto& [name, metres] : units)
    if (text == name) return metres;
  json.report("\"" + text + "\" is none of m, cm, mm, in, ft, nor metres per unit as a number");
  return fallback;
}

void read_axes(const JsonReader& root, SourceAsset& asset) {
  const std::string front = root["front"].text_or("");
  if (front == "none")
    asset.front = false;
  else if (!front.empty())
    asset.front = true;
  if (!root["up"].exists() && (front.empty() || front == "none")) return;
  const std::string up = root["up"].text_or("+y");
  const std::string usual = up == "+z" ? "-y" : "+z";
  const auto matrix = ours_from_axes(up, front.empty() || front == "none" ? usual : front);
  if (matrix)
    asset.frame.ours_from_source = *matrix;
  else
    root["front"].report(matrix.error().message);
}

}  // namespace

Status apply_sidecar(const std::string& text, const std::string& source, SourceAsset& asset) {
  const auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  root.allow_only({"$schema", "name", "tags", "category", "size", "front", "up", "units", "round",
                   "mount", "elevation", "support_height", "license", "creator"});
  AssetInfo& info = asset.info;
  info.name = root["name"].text_or(info.name, 200);
  for (const auto& tag : root["tags"].elements_or_none(100)) info.tags.push_back(tag.text(100));
  if (root["category"].exists()) asset.category = root["category"].text(100);
  if (root["size"].exists()) {
    const auto v = root["size"].numbers(3, 1e-3, largest_side);
    if (v.size() == 3) asset.frame.size = Vec3(v[0], v[1], v[2]);
  }
  read_axes(root, asset);
  asset.frame.metres_per_unit = metres_per_unit(root["units"], asset.frame.metres_per_unit);
  if (root["round"].exists()) asset.round = root["round"].boolean_or(false);
  if (root["mount"].exists()) {
    asset.mount = parse_mount(root["mount"].text());
    if (!asset.mount) root["mount"].report("is none of floor, wall, ceiling, surface");
  }
  info.elevation = root["elevation"].number_or(info.elevation, 0.0, largest_side);
  if (root["support_height"].exists())
    info.support_height = root["support_height"].number(0.0, largest_side);
  info.ref.license = root["license"].text_or("", 500);
  info.ref.creator = root["creator"].text_or("", 500);
  if (problems.first()) return *problems.first();
  return {};
}

}  // namespace roomgen::assets
