// Shape programs from strangers: those that can be read are built within their bounds.
#include <nlohmann/json.hpp>

#include "bytes.h"
#include "roomgen/base/json.h"
#include "roomgen/shape/evaluate.h"
#include "roomgen/shape/program.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace roomgen;
  constexpr std::size_t most_triangles = 5000;
  FuzzedBytes bytes{data, size};
  if (bytes.choice(2) == 0) {
    (void)shape::parse_recipe(bytes.text(), "recipe.json");
    return 0;
  }
  const auto json = parse_json(bytes.text(), "shape.json");
  if (!json) return 0;
  const auto program = shape::read_program(*json, "shape.json");
  if (!program) return 0;
  const auto shape = shape::evaluate_within(*program, most_triangles);
  if (!shape) must(!shape.error().message.empty());
  return 0;
}
