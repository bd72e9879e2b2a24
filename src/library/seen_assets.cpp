#include "seen_assets.h"

#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr double longest_side = 50.0;  // metres
constexpr double least_stretch = 0.1, most_stretch = 10.0;
constexpr std::size_t most_told_parts = 2;

// {"all": [0.8, 1.3]}, {"xy": [0.9, 1.1], "z": [0.95, 1.05]}: one factor for each.
Stretch read_stretch(const JsonReader& json) {
  Stretch stretch;
  stretch.factors.fill({1.0, 1.0});
  if (!json.exists()) return stretch;
  for (const auto& [axes, range] : json.members()) {
    const auto ends = range.numbers(2, least_stretch, most_stretch);
    const auto count = axes == "all" ? 3 : static_cast<int>(axes.size());
    if (count > 1) stretch.alike = count;
    const auto first = static_cast<std::size_t>(count > 1 ? 0 : axes.front() - 'x');
    if (ends.size() != 2 || first > 2 || count > 3) continue;
    std::fill_n(stretch.factors.begin() + static_cast<std::ptrdiff_t>(first), count,
                Interval{ends[0], ends[1]});
  }
  return stretch;
}

std::vector<std::string> texts(const JsonReader& json) {
  std::vector<std::string> result;
  for (const auto& text : json.elements_or_none(100)) result.push_back(text.text(100));
  return result;
}

SeenAsset read_asset(const JsonReader& json) {
  json.allow_only({"is", "kind", "words", "style", "formality", "parts", "has", "shape", "stretch",
                   "true_size", "looks", "flaw", "front", "mount", "unsteady"});
  SeenAsset asset;
  asset.is = json["is"].text(200);
  asset.kind = json["kind"].text(100);
  asset.words = words(json["words"].text_or("", 200));
  asset.style = texts(json["style"]);
  asset.formality = static_cast<int>(json["formality"].integer_or(3, 1, 5));
  for (const auto& part : json["parts"].elements_or_none(100))
    asset.parts.push_back({part["part"].text(100), part["color"].text(100),
                           part["material"].text(100)});
  if (json["has"].exists())
    for (const auto& [part, count] : json["has"].members())
      asset.has.parts[part] = static_cast<int>(count.integer_or(1, 0, 1000));
  asset.shape = json["shape"].text_or("");
  asset.stretch = read_stretch(json["stretch"]);
  if (json["true_size"].exists()) {
    const auto sides = json["true_size"].numbers(3, 1e-3, longest_side);
    if (sides.size() == 3) asset.true_size = Vec3(sides[0], sides[1], sides[2]);
  }
  asset.looks = static_cast<int>(json["looks"].integer_or(3, 1, 5));
  asset.is_flawed = json["flaw"].exists();
  asset.front = json["front"].boolean_or(true);
  asset.mount = parse_mount(json["mount"].text_or(""));
  asset.unsteady = json["unsteady"].boolean_or(false);
  return asset;
}

}  // namespace

std::vector<std::string> SeenAsset::told() const {
  std::string text = is + " " + shape + " " + join(words, " ") + " " + join(style, " ");
  for (std::size_t i = 0; i < std::min(parts.size(), most_told_parts); ++i)
    text += " " + parts[i].material;
  return roomgen::words(text);
}

Result<SeenAssets> parse_seen_assets(std::string_view text, const std::string& source) {
  const auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  root.allow_only({"about", "seen", "others", "assets"});
  SeenAssets result;
  for (const auto& [library, entries] : root["assets"].members())
    for (const auto& [id, entry] : entries.members())
      result[library + "/" + id] = read_asset(entry);
  if (problems.first()) return *problems.first();
  return result;
}

const SeenAssets& seen_assets() {
  // A test parses the file; a build whose data is broken has seen nothing.
  constexpr const char* file = "data/furniture-seen.json";
  static const auto assets = parse_seen_assets(resource(file).value_or("{}"), file);
  static const SeenAssets none;
  return assets ? *assets : none;
}

const SeenAsset* seen_asset(const AssetRef& asset) {
  const auto found = seen_assets().find(asset.library + "/" + asset.id);
  return found == seen_assets().end() ? nullptr : &found->second;
}

}  // namespace roomgen
