// Tables from strangers: rows of requirements, recordings of models, the properties of a furniture library.
#include <nlohmann/json.hpp>

#include "bytes.h"
#include "chat/chat_recording.h"
#include "roomgen/lab/scores.h"
#ifdef ROOMGEN_HAS_ASSETS
#include "assets/properties.h"
#endif

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedBytes bytes{data, size};
  switch (bytes.choice(3)) {
    case 0:
      (void)roomgen::lab::parse_requirements(bytes.text(), "rows.csv");
      break;
    case 1:
      (void)roomgen::parse_recording(bytes.text(), "model.jsonl");
      break;
    default:
#ifdef ROOMGEN_HAS_ASSETS
      (void)roomgen::assets::parse_properties(bytes.text());
#endif
      break;
  }
  return 0;
}
