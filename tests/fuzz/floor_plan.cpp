// Drawings from strangers: the first byte says whether the others are SVG or DXF.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "roomgen/import/import.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const auto room = data[0] % 2 == 0 ? roomgen::room_from_svg(text, "plan.svg")
                                     : roomgen::room_from_dxf(text, "plan.dxf");
  if (room && !roomgen::check(*room)) __builtin_trap();
  return 0;
}
