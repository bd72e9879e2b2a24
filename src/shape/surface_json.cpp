#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "color.h"
#include "motifs.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "solid_json.h"

namespace roomgen::shape::detail {

namespace {

void require_color(const JsonReader& json, const std::string& color) {
  if (parse_color(color)) return;
  std::vector<std::string> names;
  for (const auto name : color_names()) names.emplace_back(name);
  const std::string close = closest_name(color, names);
  json.report("\"" + color.substr(0, 60) + "\" is no colour; write \"#rrggbb\" or a name" +
              (close.empty() ? " such as oak, navy, cream" : "; did you mean \"" + close + "\"?"));
}

}  // namespace

Rgb read_color(const JsonReader& json, const Numbers& numbers) {
  const std::string color = numbers.word(json, "");
  require_color(json, color);
  return parse_color(color).value_or(Rgb{});
}

Surface read_surface(const std::string& name, const JsonReader& json, const Numbers& numbers) {
  json.allow_only(
      {"color", "roughness", "metalness", "opacity", "pattern", "second", "scale", "glow"});
  Surface surface;
  surface.name = name;
  if (!json["color"].exists())
    json["color"].report("missing; expected a colour");
  else
    require_color(json["color"], surface.color = numbers.word(json["color"], surface.color));
  surface.roughness = numbers.number_or(json["roughness"], surface.roughness, 0.0, 1.0);
  surface.metalness = numbers.number_or(json["metalness"], 0.0, 0.0, 1.0);
  surface.opacity = numbers.number_or(json["opacity"], 1.0, 0.05, 1.0);
  surface.pattern = numbers.word(json["pattern"], "none");
  const std::vector<std::string> patterns = pattern_names();
  if (std::find(patterns.begin(), patterns.end(), surface.pattern) == patterns.end() &&
      !find_motif(surface.pattern))
    json["pattern"].report("no pattern \"" + surface.pattern + "\"; there are " +
                           join(patterns, ", ") + ", and the motifs of data/motifs.json");
  surface.second = numbers.word(json["second"], "");
  if (!surface.second.empty()) require_color(json["second"], surface.second);
  surface.scale = numbers.number_or(json["scale"], 1.0, 0.05, 20.0);
  surface.glow = numbers.number_or(json["glow"], 0.0, 0.0, 1.0);
  return surface;
}

Json write_surface(const Surface& surface) {
  Json json = {{"color", surface.color},
               {"roughness", metres(surface.roughness)},
               {"metalness", metres(surface.metalness)}};
  if (metres(surface.opacity) != 1.0) json["opacity"] = metres(surface.opacity);
  if (surface.pattern != "none") json["pattern"] = surface.pattern;
  if (!surface.second.empty()) json["second"] = surface.second;
  if (metres(surface.scale) != 1.0) json["scale"] = metres(surface.scale);
  if (metres(surface.glow) != 0.0) json["glow"] = metres(surface.glow);
  return json;
}

}  // namespace roomgen::shape::detail
