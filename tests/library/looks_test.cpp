#include "library/looks.h"

#include "catch.h"

using namespace roomgen;

namespace {

AssetInfo asset(const std::string& category, std::vector<std::string> colors) {
  AssetInfo info;
  info.name = info.category = category;
  info.colors = std::move(colors);
  return info;
}

bool contradicts(const AssetInfo& info, const std::string& words) {
  return contradiction(info, wanted_looks(words), Vocabulary::built_in(),
                       [](const std::string&) { return false; }) != Contradiction::none;
}

}  // namespace

TEST_CASE("A sofa of another colour is not the red one that was asked for") {
  CHECK(contradicts(asset("sofa", {"blue", "brown"}), "red velvet"));
  CHECK_FALSE(contradicts(asset("sofa", {"red", "brown"}), "red"));
  CHECK_FALSE(contradicts(asset("sofa", {"white"}), "cream"));
  CHECK_FALSE(contradicts(asset("sofa", {"blue"}), "comfortable"));
}

TEST_CASE("The largest colour decides, and phrases of colour are read as one") {
  CHECK(contradicts(asset("desk", {"white", "black"}), "black"));
  CHECK_FALSE(contradicts(asset("desk", {"black", "white"}), "black"));
  CHECK(contradicts(asset("desk", {"blue"}), "wine red"));
  CHECK_FALSE(contradicts(asset("desk", {"purple"}), "wine red"));
}

TEST_CASE("Of what is not known nothing contradicts") {
  CHECK_FALSE(contradicts(asset("sofa", {}), "red"));
  CHECK_FALSE(contradicts(asset("sofa", {"red"}), "leather"));
  CHECK_FALSE(contradicts(asset("sofa", {"green"}), "soft"));
}

TEST_CASE("A material is contradicted by another one's name, and wood by a colour it never has") {
  AssetInfo glass = asset("coffee table", {"brown"});
  glass.tags = {"glass"};
  CHECK(contradicts(glass, "oak"));
  CHECK(contradicts(asset("coffee table", {"grey"}), "oak"));
  CHECK(contradicts(asset("office chair", {"blue"}), "leather"));
  CHECK_FALSE(contradicts(asset("coffee table", {"brown"}), "oak"));
  CHECK_FALSE(contradicts(asset("coffee table", {"white"}), "white wooden"));
}

TEST_CASE("Texts are believed of materials, but not against a colour that was measured") {
  const auto says_all = [](const std::string&) { return true; };
  CHECK(contradiction(asset("desk", {"white"}), wanted_looks("black"), Vocabulary::built_in(), says_all) != Contradiction::none);
  CHECK(contradiction(asset("desk", {"beige"}), wanted_looks("mahogany"), Vocabulary::built_in(), says_all) != Contradiction::none);
  AssetInfo both = asset("coffee table", {"brown", "grey"});
  both.tags = {"glass"};
  CHECK(contradicts(both, "oak"));
  CHECK(contradiction(both, wanted_looks("oak"), Vocabulary::built_in(), says_all) == Contradiction::none);
}

TEST_CASE("A round table is asked for, or a square one") {
  AssetInfo table = asset("dining table", {"brown"});
  CHECK(contradicts(table, "round"));
  CHECK_FALSE(contradicts(table, "square"));
  table.round = true;
  CHECK_FALSE(contradicts(table, "round"));
  CHECK(contradicts(table, "rectangular"));
}
