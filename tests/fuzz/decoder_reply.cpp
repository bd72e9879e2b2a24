// What a decoder may answer, whoever it is.
#include "bytes.h"
#include "decode/model_bytes.h"
#include "decode/wire.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = FuzzedBytes{data, size}.text();
  (void)roomgen::decode::header_from(bytes);
  (void)roomgen::decode::job_from(bytes);
  const auto model = roomgen::decode::model_from(bytes, {});
  if (!model) return 0;
  for (const auto& part : model->parts)
    for (const auto& triangle : part.mesh.triangles)
      for (const auto index : triangle)
        if (index >= part.mesh.positions.size()) must(false);
  return 0;
}
