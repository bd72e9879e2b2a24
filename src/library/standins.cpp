#include "roomgen/library/standins.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

#include "roomgen/base/random.h"
#include "roomgen/base/sha256.h"
#include "roomgen/base/text.h"
#include "roomgen/library/ranking.h"
#include "roomgen/library/vocabulary.h"
#include "roomgen/scene/category.h"

namespace roomgen {

namespace {

constexpr double standin_score = 0.1;  // any real thing that fits is better
constexpr double smallest = 0.005;     // metres
constexpr double largest = 20.0;

/// What a recipe's things usually are, where no category says.
struct Defaults {
  std::string_view recipe;
  Mount mount;
  std::array<double, 3> size;
  std::vector<std::string> colors;
  bool supports;  // its top carries things
  bool front;
  bool round;
};

const std::vector<Defaults>& defaults() {
  static const std::vector<std::string> woods = {"oak", "walnut", "white", "pine"};
  static const std::vector<std::string> metals = {"brass", "black", "steel", "white"};
  static const std::vector<Defaults> table = {
      {"table", Mount::floor, {1.2, 0.8, 0.74}, woods, true, true, false},
      {"shelf", Mount::floor, {0.9, 0.32, 1.8}, woods, true, true, false},
      {"shelf", Mount::wall, {0.9, 0.24, 0.2}, woods, true, true, false},
      {"cabinet",
       Mount::floor,
       {0.9, 0.45, 0.9},
       {"white", "oak", "walnut", "grey"},
       true,
       true,
       false},
      {"cabinet", Mount::wall, {0.8, 0.35, 0.7}, {"white", "oak", "grey"}, false, true, false},
      {"mirror",
       Mount::wall,
       {0.6, 0.03, 0.9},
       {"oak", "black", "brass", "white"},
       false,
       true,
       false},
      {"mirror",
       Mount::floor,
       {0.6, 0.04, 1.7},
       {"oak", "black", "brass", "white"},
       false,
       true,
       false},
      {"picture",
       Mount::wall,
       {0.6, 0.03, 0.45},
       {"black", "oak", "white", "walnut"},
       false,
       true,
       false},
      {"rug",
       Mount::floor,
       {2.0, 1.4, 0.012},
       {"beige", "grey", "blue", "red", "green"},
       true,
       false,
       false},
      {"lamp", Mount::floor, {0.4, 0.4, 1.5}, metals, false, false, true},
      {"lamp", Mount::surface, {0.28, 0.28, 0.45}, metals, false, false, true},
      {"lamp", Mount::ceiling, {0.4, 0.4, 0.6}, metals, false, false, true},
      {"lamp", Mount::wall, {0.2, 0.22, 0.32}, metals, false, true, false},
      {"box",
       Mount::floor,
       {0.8, 0.45, 0.45},
       {"oak", "walnut", "beige", "white"},
       true,
       true,
       false}};
  return table;
}

// Those for the mount if there are any, else the recipe's first; null for an unknown recipe.
const Defaults* defaults_of(std::string_view recipe, Mount mount) {
  const Defaults* found = nullptr;
  for (const auto& entry : defaults())
    if (entry.recipe == recipe && (!found || entry.mount == mount)) found = &entry;
  return found;
}

// Colours that recipes know, as descriptions spell them.
std::string named_color(const std::string& description) {
  static const std::vector<std::string> known = {
      "white", "black", "grey",   "brown", "beige", "red",    "orange", "yellow",
      "green", "blue",  "purple", "pink",  "brass", "walnut", "pine",   "oak"};
  for (const auto& word : words(description)) {
    const std::string spelt = word == "gray" ? "grey" : word;
    if (std::find(known.begin(), known.end(), spelt) != known.end()) return spelt;
  }
  return {};
}

// Equal queries build equal things.
std::uint64_t seed_of(const AssetQuery& query) {
  return std::strtoull(sha256_hex(query.category + "\n" + query.description).substr(0, 12).c_str(),
                       nullptr, 16);
}

const Kind* kind_asked(const AssetQuery& query) {
  const auto& vocabulary = Vocabulary::built_in();
  const auto phrase =
      vocabulary.understand(query.category.empty() ? query.description : query.category);
  return phrase.known ? vocabulary.find(phrase.kind) : nullptr;
}

// The category's usual size is that of things put up in its usual way.
Vec3 size_for(const AssetQuery& query, const Kind& kind, const Defaults& entry) {
  Vec3 size(entry.size[0], entry.size[1], entry.size[2]);
  const Category* category = CategoryTable::built_in().find(kind.name);
  if (category && category->mount == entry.mount) size = category->size;
  return query.size.value_or(size).cwiseMax(smallest).cwiseMin(largest);
}

// As scenes keep it, so that a scene that was read back asks for the same thing.
ProceduralSource source_of(const StandinSpec& spec) {
  ProceduralSource source;
  source.recipe = spec.recipe;
  source.seed = spec.seed;
  Json size = Json::array();
  for (int i = 0; i < 3; ++i) size.push_back(rounded(spec.size[i]));
  source.params = {{"size", size}, {"mount", std::string(name(spec.mount))}, {"color", spec.color}};
  return source;
}

StandinSpec spec_of(const ProceduralSource& source, const Defaults& entry) {
  StandinSpec spec{source.recipe, Vec3(entry.size[0], entry.size[1], entry.size[2]), Mount::floor,
                   entry.colors.front(), source.seed};
  JsonReader::Problems ignored("params");
  if (!source.params.is_object()) return spec;
  const JsonReader params(source.params, ignored);
  if (params["size"].exists())
    if (const auto v = params["size"].numbers(3, smallest, largest); v.size() == 3)
      spec.size = Vec3(v[0], v[1], v[2]);
  spec.mount = parse_mount(params["mount"].text_or("floor")).value_or(Mount::floor);
  spec.color = params["color"].text_or(spec.color);
  return spec;
}

class Standins final : public AssetLibrary {
 public:
  Result<std::vector<AssetMatch>> search(const AssetQuery& query) const override {
    const Kind* kind = kind_asked(query);
    if (!kind || query.limit == 0) return std::vector<AssetMatch>{};
    const Mount usual = kind->mount.value_or(Mount::floor);
    StandinSpec spec;
    spec.mount = query.mount.value_or(usual);
    const Defaults* entry = defaults_of(kind->standin, spec.mount);
    if (!entry) return std::vector<AssetMatch>{};
    spec.recipe = entry->recipe;
    spec.size = size_for(query, *kind, *entry);
    if (mount_fit(usual, spec.mount, kind->also, spec.size.z()) <= 0.0)
      return std::vector<AssetMatch>{};
    spec.seed = seed_of(query);
    spec.color = named_color(query.category + " " + query.description);
    if (spec.color.empty()) spec.color = Random(spec.seed).pick(entry->colors);
    return std::vector<AssetMatch>{{describe(spec, *kind, *entry), standin_score}};
  }

  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override {
    const Defaults* entry =
        ref.procedural ? defaults_of(ref.procedural->recipe, Mount::floor) : nullptr;
    if (!entry)
      return Error{Error::Kind::not_found, asset_key(ref) + ": no stand-in is built this way"};
    return std::make_shared<const Model>(build_standin(spec_of(*ref.procedural, *entry)));
  }

 private:
  static AssetInfo describe(const StandinSpec& spec, const Kind& kind, const Defaults& entry) {
    AssetInfo info;
    info.ref.procedural = source_of(spec);
    const StandinSpec kept = spec_of(*info.ref.procedural, entry);
    info.name = spec.color + " " + kind.name + " (stand-in)";
    info.category = kind.name;
    info.group = "stand-in";
    info.size = kept.size;
    info.mount = kept.mount;
    const Category* category = CategoryTable::built_in().find(kind.name);
    if (kept.mount == Mount::wall)
      info.elevation = category && category->elevation > 0.0 ? category->elevation : 1.2;
    if (entry.supports && kept.mount == Mount::floor) info.support_height = kept.size.z();
    info.has_front = category ? category->traits.front : entry.front;
    info.round = entry.round;
    info.colors = {spec.color};
    info.triangles = triangle_count(build_standin(kept));
    return info;
  }
};

}  // namespace

std::unique_ptr<AssetLibrary> make_standins() {
  return std::make_unique<Standins>();
}

}  // namespace roomgen
