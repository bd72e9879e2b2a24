// Drawings from strangers: the first byte says whether the others are SVG or DXF.
#include "bytes.h"
#include "roomgen/import/import.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedBytes bytes{data, size};
  const auto room = bytes.choice(2) == 0 ? roomgen::room_from_svg(bytes.text(), "plan.svg")
                                         : roomgen::room_from_dxf(bytes.text(), "plan.dxf");
  if (room && !roomgen::check(*room)) must(false);
  return 0;
}
