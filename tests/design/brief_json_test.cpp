#include <fstream>
#include <nlohmann/json.hpp>

#include "brief/brief_json.h"
#include "catch.h"
#include "plan/ledger.h"
#include "plan/planning.h"
#include "read_brief.h"
#include "solve/arrangement.h"

using namespace roomgen;

namespace {

const brief::RoomKinds& room_kinds() {
  return *brief::built_in_room_kinds();
}

std::vector<std::string> prompts_of(const std::string& file) {
  std::ifstream in(std::string(ROOMGEN_SOURCE) + "/" + file);
  std::vector<std::string> prompts;
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) prompts.push_back(line);
  return prompts;
}

std::string plan_text(const PlanRequest& request, const brief::Brief& brief) {
  const auto plan = plan::make_plan(request, brief, room_kinds(), KindTable::built_in(),
                                    *built_in_arrangements());
  return plan ? dump_json(to_json(*plan)) : plan.error().message;
}

// As it comes back from a file.
brief::BriefReading written_and_read(const brief::Brief& said, const std::string& prompt) {
  const std::string file = dump_json(brief::to_json(said, prompt));
  return brief::brief_from_json(*parse_json(file, "brief.json"), prompt, room_kinds(),
                                KindTable::built_in(), {.author = brief::FormAuthor::roomgen});
}

}  // namespace

TEST_CASE("What rules read is the same once it went through brief.json") {
  auto prompts = prompts_of("bench/golden/prompts.txt");
  for (auto& prompt : prompts_of("bench/readers/prompts.txt")) prompts.push_back(prompt);
  REQUIRE(prompts.size() >= 160);
  for (std::size_t i = 0; i < prompts.size(); ++i) {
    PlanRequest request;
    request.prompt = prompts[i];
    INFO(request.prompt);
    brief::Brief said = brief::read_words(request.prompt, room_kinds(), KindTable::built_in());
    auto again = written_and_read(said, request.prompt);
    CHECK(again.problems == std::vector<std::string>());
    brief::conclude(said, room_kinds(), KindTable::built_in());
    brief::conclude(again.brief, room_kinds(), KindTable::built_in());
    // What is concluded decides on the plan; that it does shows every eighth, a plan takes its
    // time.
    CHECK(brief::to_json(again.brief, request.prompt) == brief::to_json(said, request.prompt));
    if (i % 8 == 0) CHECK(plan_text(request, again.brief) == plan_text(request, said));
  }
}
