// Journals from strangers: what is whole in them lies within their bytes, in order.
#include <nlohmann/json.hpp>

#include "bytes.h"
#include "session/journal.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto journal = roomgen::read_journal(FuzzedBytes{data, size}.text(), "scene.journal");
  if (journal) must(journal->whole_bytes <= size);
  return 0;
}
