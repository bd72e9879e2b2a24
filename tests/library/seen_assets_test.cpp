#include "library/seen_assets.h"

#include <nlohmann/json.hpp>
#include <set>

#include "base/resource.h"
#include "catch.h"
#include "library/asset_object.h"
#include "library/looks.h"
#include "library/vocabulary.h"
#include "roomgen/base/json.h"

using namespace roomgen;

namespace {

Vec3 usual(const char* name) { return KindTable::built_in().get(name).size; }

AssetInfo asset(const char* library, const char* id, const char* category, Vec3 size) {
  AssetInfo info;
  info.ref.library = library;
  info.ref.id = id;
  info.category = category;
  info.size = size;
  return info;
}

bool lacks(const AssetInfo& info, const std::string& description) {
  return contradiction(info, wanted_looks(description), Vocabulary::built_in(),
                       [](const std::string&) { return true; }) == Contradiction::form;
}

}  // namespace

TEST_CASE("Every seen asset is of a kind that there is, or of one of those that are no furniture") {
  const auto text = resource("data/furniture-seen.json");
  REQUIRE(text);
  const auto seen = parse_seen_assets(*text, "furniture-seen.json");
  if (!seen) FAIL(seen.error().message);
  CHECK(seen->size() > 700);
  std::set<std::string> others, left;
  const Json table = *parse_json(*text, "furniture-seen.json");
  for (const auto& other : table["others"])
    others.insert(other.get<std::string>());
  left = others;
  for (const auto& [name, asset] : *seen) {
    INFO(name << ": " << asset.kind);
    left.erase(asset.kind);
    CHECK((Vocabulary::built_in().find(asset.kind) != nullptr) != (others.count(asset.kind) > 0));
    CHECK_FALSE(asset.is.empty());
    CHECK(asset.parts.empty() == asset.unsteady);
    for (const auto& factor : asset.stretch.factors) CHECK((factor.low <= 1.0 && factor.high >= 1.0));
  }
  CHECK(left.empty());
}

TEST_CASE("A part that is demanded counts as who saw the asset counted it") {
  const AssetInfo oven = asset("BlendSwap-CC-0", "doubleOven", "oven", {0.6, 0.6, 0.9});
  const AssetInfo range = asset("BlendSwap-CC-BY", "largeStove", "stove", {0.9, 0.6, 0.9});
  const AssetInfo dresser = asset("BlendSwap-CC-BY", "dresserWithDrawers", "dresser", {1.6, 0.5, 0.8});
  CHECK(lacks(oven, "a cooker with hobs"));
  CHECK_FALSE(lacks(range, "a cooker with hobs"));
  CHECK_FALSE(lacks(range, "a six burner cooker"));
  CHECK(lacks(range, "a four burner cooker"));
  CHECK(lacks(dresser, "a low cabinet with sliding doors"));
  CHECK_FALSE(lacks(dresser, "a low cabinet with six drawers"));
}

TEST_CASE("A mesh is stretched as far as who saw it allows, and what is then far off contradicts") {
  // all: [0.8, 1.3]
  const AssetInfo lantern = asset("BlendSwap-CC-0", "JapaneseLantern", "lantern", {0.3, 0.3, 0.5});
  const Vec3 grown = fitted_size(lantern, usual("lantern"), {0.6, 0.6, 1.0});
  CHECK((grown - 1.3 * lantern.size).norm() < 1e-9);
  CHECK(contradicts_size(lantern, usual("lantern"), {0.6, 0.6, 1.0}));
  // x: [0.8, 1.2], y: [0.85, 1.15], z: [0.9, 1.2]
  const AssetInfo dresser = asset("BlendSwap-CC-BY", "dresserWithDrawers", "dresser", {1.6, 0.5, 0.8});
  const Vec3 fitted = fitted_size(dresser, usual("dresser"), {1.44, 0.3, 0.9});
  CHECK((fitted - Vec3(1.44, 0.425, 0.9)).norm() < 1e-9);
  CHECK(contradicts_size(dresser, usual("dresser"), {1.44, 0.3, 0.9}));
  CHECK_FALSE(contradicts_size(dresser, usual("dresser"), {1.44, 0.4, 0.9}));
}

TEST_CASE("A size that was named is kept within a quarter, what is usual within two fifths") {
  AssetInfo table = asset("mine", "table", "dining table", {1.6, 0.9, 0.75});
  const Vec3 kind = usual("dining table");
  CHECK_FALSE(contradicts_size(table, kind, {1.8, 0.9, kind.z()}));
  CHECK(contradicts_size(table, kind, {3.0, 1.0, kind.z()}));
  table.has_front = true;
  CHECK(contradicts_size(table, kind, {0.9, 1.6, kind.z()}));
  table.has_front = false;
  CHECK_FALSE(contradicts_size(table, kind, {0.9, 1.6, kind.z()}));
  table.size.z() = 0.45;
  CHECK(contradicts_size(table, kind, {1.8, 0.9, kind.z()}));
}
