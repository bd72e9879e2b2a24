// Valid documents changed at random: nothing crashes or hangs, and what is accepted is sound.
#include <chrono>
#include <nlohmann/json.hpp>

#include "base/random.h"
#include "roomgen/base/json.h"
#include "shape_files.h"

using namespace roomgen;
using namespace roomgen::shape;

namespace {

void collect(Json& json, std::vector<Json*>& values) {
  values.push_back(&json);
  if (json.is_structured())
    for (auto& element : json) collect(element, values);
}

Json odd_value(Random& random, const std::vector<Json*>& values) {
  const std::vector<Json> odd = {nullptr,
                                 true,
                                 0,
                                 -1,
                                 1e300,
                                 1e-300,
                                 3.5,
                                 4096,
                                 1000000,
                                 "",
                                 "x",
                                 "i",
                                 "1 / 0",
                                 "hash(i)",
                                 "$seat",
                                 Json::array(),
                                 Json::object(),
                                 Json::array({1, 2, 3}),
                                 {{"array", {{"count", 3}, {"step", {"i", 0, 0}}}}},
                                 "w * n + j",
                                 "all"};
  if (random.chance(0.3)) return *random.pick(values);
  return random.pick(odd);
}

void mutate(Json& document, Random& random) {
  std::vector<Json*> values;
  collect(document, values);
  Json& target = *random.pick(values);
  const Json wanted = odd_value(random, values);
  switch (random.integer(0, 4)) {
    case 0:
      target = wanted;
      break;
    case 1:
      if (target.is_array())
        target.push_back(wanted);
      else if (target.is_number())
        target = target.get<double>() * random.uniform(-3, 3);
      break;
    case 2:
      if (target.is_structured() && !target.empty()) {
        const auto index = random.integer(0, static_cast<int>(target.size()) - 1);
        if (target.is_array())
          target.erase(static_cast<std::size_t>(index));
        else
          target.erase(std::next(target.begin(), index));
      }
      break;
    case 3:
      if (target.is_array() && !target.empty()) {
        const Json copy = random.pick(std::vector<Json>(target.begin(), target.end()));
        target.push_back(copy);
      }
      break;
    default:
      if (target.is_string()) {
        std::string text = target.get<std::string>();
        if (!text.empty())
          text[static_cast<std::size_t>(random.integer(0, static_cast<int>(text.size()) - 1))] =
              static_cast<char>(random.integer(32, 126));
        target = text;
      }
  }
}

}  // namespace

TEST_CASE("Documents changed at random are refused with a message or make something") {
  Random random(17);
  int accepted = 0, refused = 0;
  for (int round = 0; round < 3000; ++round) {
    Json json = shape_file(random.pick(shape_names));
    for (int k = random.integer(1, 3); k > 0; --k) mutate(json, random);
    const auto start = std::chrono::steady_clock::now();
    const auto program = instantiate(json, {}, 1, recipes_in(shapes_folder), "mutated");
    if (!program) {
      ++refused;
      CHECK(program.error().message.rfind("mutated: ", 0) == 0);
    } else {
      ++accepted;
      const std::string text = dump_json(write_program(*program));
      const auto again = read_program(parsed(text), "again");
      INFO((again ? "" : again.error().message + "\n" + text));
      REQUIRE(again);
      CHECK(dump_json(write_program(*again)) == text);
      if (round % 10 == 0) (void)evaluate(*program, 0.01);
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    INFO(json.dump());
    CHECK(took.count() < 20.0);
  }
  CHECK(accepted > 100);
  CHECK(refused > 100);
}
