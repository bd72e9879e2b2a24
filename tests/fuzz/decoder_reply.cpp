// What a decoder may answer, whoever it is.
#include "bytes.h"
#include "decode/model_bytes.h"
#include "decode/wire.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = FuzzedBytes{data, size}.text();
  (void)roomgen::decode::header_from(bytes);
  (void)roomgen::decode::job_from(bytes);
  (void)roomgen::decode::picture_job_from(bytes);
  if (const auto image = roomgen::decode::image_from(bytes, 64))
    must(image->pixels.size() == 4 * static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height));
  const auto model = roomgen::decode::model_from(bytes, {});
  if (!model) return 0;
  for (const auto& part : model->parts)
    for (const auto& triangle : part.mesh.triangles)
      for (const auto index : triangle)
        if (index >= part.mesh.positions.size()) must(false);
  return 0;
}
