// Random rooms and things instead of random bytes: whatever the problem, its solution is valid, or the error says why
// there is none.
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bytes.h"
#include "roomgen/base/json.h"
#include "roomgen/evaluate/report.h"
#include "roomgen/solve/solve.h"

namespace {

using namespace roomgen;

constexpr std::size_t most_things = 8;
constexpr std::array kinds = {"bed", "desk", "chair", "sofa", "bookcase", "rug", "floor lamp", "plant", "table", "mirror"};
constexpr std::array room_relations = {"edge", "middle"};
constexpr std::array relations = {"near", "far", "in front of", "around", "face to", "center align with"};

/// Numbers out of bytes, all zero when these have ended.
class Numbers {
 public:
  explicit Numbers(FuzzedBytes bytes) : bytes_(bytes) {}
  std::size_t below(std::size_t count) { return bytes_.choice(count); }
  double between(double least, double most) { return least + (most - least) * static_cast<double>(below(256)) / 255.0; }

 private:
  FuzzedBytes bytes_;
};

Json room_of(Numbers& numbers) {
  const double width = numbers.between(1.5, 8.0), depth = numbers.between(1.5, 8.0);
  Json corners = {{0.0, 0.0}, {width, 0.0}, {width, depth}, {0.0, depth}};
  if (numbers.below(2) == 1) {
    // A corner cut out: an L.
    const double x = width * numbers.between(0.3, 0.7), y = depth * numbers.between(0.3, 0.7);
    corners = {{0.0, 0.0}, {width, 0.0}, {width, y}, {x, y}, {x, depth}, {0.0, depth}};
  }
  const double door = numbers.between(0.0, width - 1.0);
  const Json segment = {{door, 0.0}, {door + 0.9, 0.0}};
  return {{"name", "fuzzed"}, {"room", corners}, {"doors", {{{"segment", segment}}}}};
}

// "edge | near, thing-0".
std::string constraints_of(Numbers& numbers, const std::vector<std::string>& earlier) {
  std::string all;
  for (std::size_t k = numbers.below(3); k > 0; --k) {
    if (!all.empty()) all += " | ";
    if (earlier.empty() || numbers.below(3) == 0)
      all += room_relations[numbers.below(room_relations.size())];
    else
      all += std::string(relations[numbers.below(relations.size())]) + ", " + earlier[numbers.below(earlier.size())];
  }
  return all;
}

Json things_of(Numbers& numbers) {
  Json things = Json::array();
  std::vector<std::string> names;
  const std::size_t count = 1 + numbers.below(most_things);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = std::string(kinds[numbers.below(kinds.size())]) + "-" + std::to_string(i);
    Json thing = {{"name", name},
                  {"size", {numbers.between(0.2, 2.2), numbers.between(0.2, 2.2), numbers.between(0.1, 2.0)}}};
    if (const std::string constraints = constraints_of(numbers, names); !constraints.empty())
      thing["constraints"] = constraints;
    things.push_back(thing);
    names.push_back(name);
  }
  return things;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Numbers numbers({data, size});
  Json json = room_of(numbers);
  json["objects"] = things_of(numbers);
  const auto problem = problem_from_json(json, "problem.json");
  if (!problem) return 0;
  SolveOptions options;
  options.rounds = 5;
  const auto solution = solve(*problem, {}, KindTable::built_in(), options);
  if (!solution) {
    must(!solution.error().message.empty());
    return 0;
  }
  must(solution->scene.objects.size() + solution->scene.unplaced.size() == problem->tasks.size());
  must(examine(solution->scene, {}, KindTable::built_in()).violations.empty());
  return 0;
}
