// Sentences from strangers: whatever they say, reading them ends.
#include "brief/prompt.h"
#include "bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto& kinds = roomgen::brief::built_in_room_kinds();
  roomgen::brief::read_prompt(FuzzedBytes{data, size}.text(), *kinds,
                               roomgen::KindTable::built_in());
  return 0;
}
