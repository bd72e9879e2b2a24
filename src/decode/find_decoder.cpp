#include <cstdlib>
#include <string>

#include "decoder.h"

namespace roomgen::decode {

namespace fs = std::filesystem;

Result<fs::path> find_decoder() {
  const std::string name = "roomgen-decode";
  std::error_code failed;
  if (const char* named = std::getenv("ROOMGEN_DECODER"); named && *named) {
    if (fs::exists(named, failed)) return fs::path(named);
    return Error{Error::Kind::unavailable,
                 std::string("ROOMGEN_DECODER names ") + named + ", which is not there"};
  }
  const auto beside = fs::read_symlink("/proc/self/exe", failed).parent_path();
  for (const fs::path& folder : {beside, beside / ROOMGEN_DECODER_FROM_PROGRAM,
                                 fs::path(ROOMGEN_DECODER_INSTALLED), fs::path(ROOMGEN_DECODER_BUILT)})
    if (fs::exists(folder / name, failed)) return folder / name;
  return Error{Error::Kind::unavailable,
               name + ", which reads meshes, is missing beside the program; name it in ROOMGEN_DECODER"};
}

}  // namespace roomgen::decode
