// scene.json from strangers: what can be read can be written and read again.
#include <nlohmann/json.hpp>

#include "bytes.h"
#include "roomgen/base/json.h"
#include "roomgen/scene/scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto json = roomgen::parse_json(FuzzedBytes{data, size}.text(), "scene.json");
  if (!json) return 0;
  const auto scene = roomgen::scene_from_json(*json, "scene.json");
  if (scene && !roomgen::scene_from_json(roomgen::to_json(*scene), "written.json"))
    must(false);
  return 0;
}
