#include <algorithm>

#include "catch.h"
#include "plans.h"

using namespace roomgen;
using namespace roomgen::brief;

namespace {

// What the plan says of gaps of the things of a category, as text.
std::vector<std::string> gaps_of(const std::string& prompt, const std::string& category) {
  std::vector<std::string> gaps;
  for (const auto& item : test::plan_of(prompt).items)
    for (const auto& relation : item.relations)
      if (item.category == category && relation.kind == RelationKind::gap) gaps.push_back(to_text(relation));
  return gaps;
}

bool has_clause(const std::string& prompt, const std::string& clause) {
  const auto plan = test::plan_of(prompt);
  return std::any_of(plan.requirements.begin(), plan.requirements.end(), [&](const auto& one) { return one.clause == clause; });
}

}  // namespace

TEST_CASE("How far things are apart is read") {
  struct Said {
    const char *prompt, *category;
    std::vector<std::string> gaps;
  };
  const Said said[] = {
      {"A study with a desk and an armchair 0.8 m from the desk.", "armchair", {"gap 0.8 m, desk-0"}},
      {"A bedroom with two single beds 60 cm apart.", "single bed", {"gap 0.6 m, single bed-0"}},
      {"A corridor with a fire extinguisher within 1 m of the door.", "fire extinguisher", {"gap at most 1 m, door-0"}},
      {"A living room with a sofa 1 m from the wall.", "sofa", {"gap 1 m, wall"}},
      {"A games room with a pool table at least 1.5 m away from every wall.",
       "pool table",
       {"gap at least 1.5 m, wall-0", "gap at least 1.5 m, wall-1", "gap at least 1.5 m, wall-2", "gap at least 1.5 m, wall-3"}},
      {"A studio with a photo backdrop and a camera tripod 2 m in front of the backdrop.",
       "camera tripod",
       {"gap 2 m, photo backdrop-0"}},
  };
  for (const auto& [prompt, category, gaps] : said) {
    INFO(prompt);
    CHECK(gaps_of(prompt, category) == gaps);
  }
}

TEST_CASE("A distance is a requirement and no size") {
  CHECK(has_clause("A study with a desk and an armchair 0.8 m from the desk.", "armchair 0.8 m from desk"));
  CHECK(has_clause("A games room with a pool table at least 1.5 m away from every wall.", "pool table at least 1.5 m from each wall"));
  for (const auto& requirement : test::plan_of("A studio with a photo backdrop and a camera tripod 2 m in front of the backdrop.").requirements)
    CHECK(requirement.clause.find("longer side") == std::string::npos);
}
