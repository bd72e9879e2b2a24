#include "mcp/page.h"

#include "catch.h"
#include "support/contains.h"

using namespace roomgen::mcp;
using roomgen::Json;

namespace {

/// Of things and clauses, some of them long, and one longer than a page.
Report report() {
  Report report{{{"prompt", "a hall"}, {"objects", Json::array()}, {"clauses", Json::array()}},
                {"objects", "clauses"},
                {"a hall"},
                {}};
  for (int i = 0; i < 900; ++i) {
    const std::string name = "chair-" + std::to_string(i) + std::string(i == 450 ? 2 * page_bytes : i % 90, 'x');
    report.data[i < 700 ? "objects" : "clauses"].push_back({{"id", name}});
    report.lines.push_back("  " + name);
  }
  return report;
}

}  // namespace

TEST_CASE("The pages of a report have each entry once, in order, and none is long without need") {
  const Report whole = report();
  Json objects = Json::array(), clauses = Json::array();
  std::string text;
  std::size_t pages = 0;
  for (std::size_t skip = 0;; ++pages) {
    const auto page = page_of(whole, skip);
    REQUIRE(page);
    CHECK(page->data["prompt"] == "a hall");
    const auto& here = page->data;
    const std::size_t told = here["objects"].size() + here["clauses"].size();
    REQUIRE(told > 0);
    const std::size_t bytes = roomgen::json_line(here["objects"]).size() +
                              roomgen::json_line(here["clauses"]).size();
    if (told > 1) CHECK(bytes < page_bytes);
    for (const auto& each : here["objects"]) objects.push_back(each);
    for (const auto& each : here["clauses"]) clauses.push_back(each);
    text += page->content[0]["text"].get<std::string>() + "\n";
    if (!here.contains("next")) break;
    CHECK(here["next"] == skip + told);
    CHECK(contains_text(text, std::to_string(900 - skip - told) + " more: the same call with skip " +
                                  std::to_string(skip + told)));
    skip += told;
  }
  CHECK(pages > 2);
  CHECK(objects == whole.data["objects"]);
  CHECK(clauses == whole.data["clauses"]);
  for (const auto& line : whole.lines) REQUIRE(contains_text(text, line + "\n"));
  CHECK(contains_text(page_of(whole, 900).error().message, "only 900 entries"));
}

TEST_CASE("A report without entries is one page") {
  const auto page = page_of({{{"objects", Json::array()}}, {"objects"}, {"an empty hall"}, {}}, 0);
  REQUIRE(page);
  CHECK(page->content[0]["text"] == "an empty hall");
  CHECK_FALSE(page->data.contains("next"));
}
