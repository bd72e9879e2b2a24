#include <algorithm>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "fixture.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"

using namespace roomgen;

namespace {

Json retrieval_cases() {
  const auto text = read_file(std::string(ROOMGEN_TEST_DATA) + "/retrieval.json");
  REQUIRE(text);
  const auto json = parse_json(*text, "retrieval.json");
  REQUIRE(json);
  return *json;
}

AssetQuery query_of(const Json& json) {
  AssetQuery query;
  query.category = json.value("category", "");
  query.description = json.value("description", "");
  if (json.contains("size")) query.size = Vec3(json["size"][0], json["size"][1], json["size"][2]);
  if (json.contains("mount")) query.mount = parse_mount(json["mount"].get<std::string>());
  return query;
}

std::string first_answer(const assets::Catalogue& catalogue, const AssetQuery& query) {
  const auto matches = catalogue.search(query);
  REQUIRE(matches);
  if (matches->empty()) return "nothing";
  const AssetRef& ref = matches->front().asset.ref;
  return ref.library + "/" + ref.id;
}

}  // namespace

TEST_CASE("The first answer is what a person would accept for at least 85 of 100 queries") {
  const auto* catalogue = furniture();
  if (!catalogue) return;
  const Json cases = retrieval_cases()["queries"];
  std::size_t good = 0;
  for (const auto& entry : cases) {
    const std::string answer = first_answer(*catalogue, query_of(entry));
    const auto& accept = entry["accept"];
    const bool accepted = std::find(accept.begin(), accept.end(), answer) != accept.end();
    good += accepted;
    if (!accepted)
      UNSCOPED_INFO(entry["category"] << ", " << entry.value("description", "") << ": " << answer);
  }
  UNSCOPED_INFO(good << " of " << cases.size());
  CHECK(cases.size() >= 100);
  CHECK(static_cast<double>(good) >= 0.85 * static_cast<double>(cases.size()));
}

TEST_CASE("Kinds that the libraries lack are answered with nothing") {
  const auto* catalogue = furniture();
  if (!catalogue) return;
  const Json cases = retrieval_cases()["absent"];
  std::size_t good = 0;
  for (const auto& entry : cases) {
    const std::string answer = first_answer(*catalogue, query_of(entry));
    good += answer == "nothing";
    if (answer != "nothing") UNSCOPED_INFO(entry["category"] << ": " << answer);
  }
  UNSCOPED_INFO(good << " of " << cases.size());
  CHECK(cases.size() >= 30);
  CHECK(static_cast<double>(good) >= 0.9 * static_cast<double>(cases.size()));
}

TEST_CASE("Equal queries get equal answers") {
  const auto* catalogue = furniture();
  if (!catalogue) return;
  const AssetQuery query{.category = "chair", .description = "a wooden chair"};
  const auto first = catalogue->search(query), second = catalogue->search(query);
  REQUIRE(first);
  REQUIRE(second);
  REQUIRE(first->size() == second->size());
  for (std::size_t i = 0; i < first->size(); ++i) {
    CHECK((*first)[i].asset.ref == (*second)[i].asset.ref);
    CHECK((*first)[i].score == (*second)[i].score);
  }
}

TEST_CASE("A size that nothing comes near is answered with nothing") {
  const auto* catalogue = furniture();
  if (!catalogue) return;
  const auto matches = catalogue->search({.category = "sofa", .size = Vec3(0.4, 0.4, 2.5)});
  REQUIRE(matches);
  CHECK(matches->empty());
}
