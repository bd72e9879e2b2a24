// Sentences from strangers: whatever they say, reading them ends.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "brief/prompt.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto& kinds = roomgen::design::built_in_room_kinds();
  roomgen::design::read_prompt({reinterpret_cast<const char*>(data), size}, *kinds,
                               roomgen::KindTable::built_in());
  return 0;
}
