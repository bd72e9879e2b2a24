#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/resource.h"
#include "catch.h"
#include "fixture.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/create/create.h"

using namespace roomgen;

namespace {

AssetQuery query_of(const Json& json) {
  AssetQuery query;
  query.category = json["category"];
  query.description = json["description"];
  query.size = Vec3(json["size"][0], json["size"][1], json["size"][2]);
  query.sized = true;
  query.asked = json.value("asked", false);
  query.mount = parse_mount(json.value("mount", "floor"));
  return query;
}

// As rooms look for it: in the libraries, then among what can be built.
std::shared_ptr<const AssetLibrary> whole_library(const assets::Catalogue& catalogue) {
  const std::shared_ptr<const AssetLibrary> real(&catalogue, [](const AssetLibrary*) {});
  return create::make_finishing_library(make_first_of({real, create::make_created_library()}));
}

std::string first_answer(const AssetLibrary& library, const AssetQuery& query) {
  const auto matches = library.search(query);
  REQUIRE(matches);
  if (matches->empty()) return "nothing";
  const AssetInfo& asset = matches->front().asset;
  return asset.ref.procedural ? "made " + asset.category : asset.ref.library + "/" + asset.ref.id;
}

bool lists(const Json& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

TEST_CASE("What is taken has the name, the parts, the looks and the size that were said, in all cases but one") {
  const auto* catalogue = furniture();
  if (!catalogue) return;
  const auto library = whole_library(*catalogue);
  const Json cases = (*parse_json(*read_file(std::string(ROOMGEN_TEST_DATA) + "/asset-choices.json"), "choices"))["cases"];
  std::size_t good = 0;
  for (const auto& entry : cases) {
    const std::string answer = first_answer(*library, query_of(entry));
    const bool accepted = entry.contains("only") ? lists(entry["only"], answer)
                                                 : answer != "nothing" && !lists(entry["never"], answer);
    good += accepted;
    UNSCOPED_INFO((accepted ? "" : "WRONG ") << entry["description"] << ": " << answer);
  }
  UNSCOPED_INFO(good << " of " << cases.size());
  CHECK(cases.size() >= 40);
  CHECK(good + 1 >= cases.size());
}

TEST_CASE("Materials that who saw an asset names are those of its mesh") {
  const auto* catalogue = furniture();
  if (!catalogue) return;
  constexpr std::size_t every = 12;  // all of them take a minute
  const Json table = (*parse_json(*resource("data/furniture-seen.json"), "seen"))["assets"];
  const auto all = catalogue->all();
  REQUIRE(all);
  for (std::size_t i = 0; i < all->size(); i += every) {
    const AssetRef& ref = (*all)[i].ref;
    INFO(ref.library << "/" << ref.id);
    const auto model = catalogue->load(ref);
    REQUIRE(model);
    for (const auto& part : table.at(ref.library).at(ref.id).at("parts"))
      for (const auto& name : part["of"])
        CHECK(std::any_of((*model)->materials.begin(), (*model)->materials.end(),
                          [&](const Material& material) { return name == material.name; }));
  }
}
