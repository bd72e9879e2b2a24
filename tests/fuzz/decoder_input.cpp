// Pictures from strangers as the decoder reads them. Meshes go through the system's importer, which is known to break:
// there it is the decoder's process that holds what it does (scripts/try-meshes).
#include "bytes.h"
#include "decode/image_decode.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr int most_pixels = 64;
  const auto image = roomgen::decode::decode_image(FuzzedBytes{data, size}.text(), most_pixels);
  if (!image) return 0;
  must(image->width > 0 && image->width <= most_pixels && image->height > 0 && image->height <= most_pixels);
  return 0;
}
