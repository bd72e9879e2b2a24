#include "roomgen/library/library.h"

#include "catch.h"

using namespace roomgen;

namespace {

/// Knows one category and one asset.
class OneThing final : public AssetLibrary {
 public:
  OneThing(std::string category, std::string library, bool contradicts = false)
      : category_(std::move(category)), library_(std::move(library)), contradicts_(contradicts) {}
  Result<std::vector<AssetMatch>> search(const AssetQuery& query) const override {
    std::vector<AssetMatch> matches;
    if (query.category != category_) return matches;
    matches.emplace_back();
    matches.back().asset.ref.library = library_;
    if (contradicts_) matches.back().contradicts = Contradiction::form;
    matches.back().asset.ref.id = category_;
    return matches;
  }
  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override {
    if (ref.id != category_) return Error{Error::Kind::not_found, ref.id};
    return std::make_shared<const Model>();
  }

 private:
  std::string category_, library_;
  bool contradicts_;
};

}  // namespace

TEST_CASE("The first library that has something answers") {
  const auto library =
      make_first_of({std::make_shared<OneThing>("table", "one"),
                     std::make_shared<OneThing>("mirror", "two"),
                     std::make_shared<OneThing>("table", "three")});
  const auto real = library->search({.category = "table"});
  REQUIRE(real);
  CHECK(real->front().asset.ref.library == "one");
  const auto built = library->search({.category = "mirror"});
  REQUIRE(built);
  CHECK(built->front().asset.ref.library == "two");
  CHECK(library->load(real->front().asset.ref));
  CHECK(library->load(built->front().asset.ref));
}

TEST_CASE("What contradicts the query comes only when there is nothing else") {
  const auto red = std::make_shared<OneThing>("sofa", "red sofas", true);
  const auto built = std::make_shared<OneThing>("sofa", "built");
  CHECK(make_first_of({red, built})->search({.category = "sofa"})->front().asset.ref.library == "built");
  CHECK(make_first_of({red})->search({.category = "sofa"})->front().asset.ref.library == "red sofas");
}

TEST_CASE("What no library knows is nothing, and cannot be loaded") {
  const auto library = make_first_of({std::make_shared<OneThing>("table", "one")});
  const auto matches = library->search({.category = "sofa"});
  REQUIRE(matches);
  CHECK(matches->empty());
  CHECK(library->load({}).error().kind == Error::Kind::not_found);
}
