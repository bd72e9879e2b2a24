
#include "base/random.h"
#include "brief/prompt.h"
#include "brief/prompt_words.h"
#include "brief/room_kinds.h"
#include "catch.h"
#include "roomgen/design/designer.h"
#include "roomgen/kinds/kind_table.h"

using namespace roomgen;
using namespace roomgen::brief;

namespace {

std::vector<std::string> word_pool() {
  std::vector<std::string> pool = {"a",
                                   "the",
                                   "it",
                                   ",",
                                   ".",
                                   "4x5",
                                   "m",
                                   "12'",
                                   "0x0",
                                   "99999999999999999999",
                                   "\xF0\x9F\x9B\x8F",
                                   "\xE3\x81\x82",
                                   "\xff\xfe",
                                   "\"",
                                   "(",
                                   "\t",
                                   "x",
                                   "-",
                                   "1e9",
                                   "one",
                                   "each",
                                   "other",
                                   "NO",
                                   "window",
                                   "wall",
                                   "corner",
                                   "&"};
  for (const auto& [phrase, placement] : built_in_vocabulary()->placements) pool.push_back(phrase);
  for (const auto& [name, category] : KindTable::built_in().all()) pool.push_back(name);
  for (const auto& [type, kind] : built_in_room_kinds()->types) pool.push_back(type);
  for (const auto& [word, number] : built_in_vocabulary()->numbers) pool.push_back(word);
  for (const auto& word : built_in_vocabulary()->stops) pool.push_back(word);
  return pool;
}

std::string random_prompt(const std::vector<std::string>& pool, Random& random, int words) {
  std::string prompt;
  for (int i = 0; i < words; ++i) prompt += random.pick(pool) + (random.chance(0.9) ? " " : "");
  return prompt;
}

std::string random_bytes(Random& random, int count) {
  std::string bytes;
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(random.integer(0, 255));
  return bytes;
}

}  // namespace

TEST_CASE("any words are read without harm") {
  const auto pool = word_pool();
  Random random(11);
  for (int i = 0; i < 500; ++i) {
    const std::string prompt = i % 10 == 0 ? random_bytes(random, random.integer(1, 300))
                                           : random_prompt(pool, random, random.integer(1, 40));
    const Brief brief = read_prompt(prompt, *built_in_room_kinds(), KindTable::built_in());
    for (const auto& mention : brief.mentions) {
      REQUIRE(mention.quantity >= 1);
      REQUIRE(mention.size.minCoeff() > 0.0);
      for (const auto& demand : mention.demands)
        REQUIRE((demand.mention == Demand::none || demand.mention < brief.mentions.size()));
    }
  }
}

TEST_CASE("any words give a sound plan") {
  const auto pool = word_pool();
  Random random(12);
  const auto designer = make_rule_designer();
  int planned = 0;
  for (int i = 0; i < 60; ++i) {
    PlanRequest request;
    request.prompt = "bedroom, " + random_prompt(pool, random, random.integer(1, 25));
    request.seed = static_cast<std::uint64_t>(i);
    const auto plan = designer->plan(request);
    INFO(request.prompt);
    // Among so many things a bed may find no place.
    if (!plan.ok()) {
      CHECK(plan.error().message.find("cannot be one") != std::string::npos);
      continue;
    }
    ++planned;
    CHECK(check(plan->room).ok());
    for (const auto& item : plan->items) CHECK((item.quantity >= 1 && item.quantity <= 200));
  }
  CHECK(planned > 50);
}

TEST_CASE("a very long prompt is read or said not to be") {
  const auto pool = word_pool();
  Random random(13);
  std::string prompt;
  while (prompt.size() < max_prompt_bytes - 100) prompt += random_prompt(pool, random, 50) + ". ";
  prompt.resize(max_prompt_bytes);
  for (const auto& text :
       {prompt, std::string(max_prompt_bytes, 'a'), std::string(max_prompt_bytes, '7'),
        std::string(max_prompt_bytes / 3, ',')}) {
    PlanRequest request;
    request.prompt = text;
    const auto plan = make_rule_designer()->plan(request);
    CHECK((plan || plan.error().kind == Error::Kind::not_understood));
  }
}
