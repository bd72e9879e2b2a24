// JSON documents from strangers, but for scenes: what can be read can be written and read again.
#include <nlohmann/json.hpp>

#include "bytes.h"
#include "roomgen/base/json.h"
#include "roomgen/lab/program.h"
#include "roomgen/scene/plan.h"
#include "roomgen/scene/problem.h"
#include "roomgen/edit/operation.h"
#include "roomgen/lab/tour.h"

namespace {

using namespace roomgen;
using namespace roomgen::lab;

template <typename Read>
void again(const Json& json, Read read) {
  const auto document = read(json, "document.json");
  if (document) must(read(to_json(*document), "written.json").ok());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedBytes bytes{data, size};
  const auto which = bytes.choice(6);
  const auto json = parse_json(bytes.text(), "document.json");
  if (!json) return 0;
  switch (which) {
    case 0:
      again(*json, plan_from_json);
      break;
    case 1:
      again(*json, dwelling_plan_from_json);
      break;
    case 2:
      again(*json, program_from_json);
      break;
    case 3:
      again(*json, edit::operation_from_json);
      break;
    case 4:
      again(*json, tour_from_json);
      break;
    default:
      (void)problem_from_json(*json, "problem.json");
  }
  return 0;
}
