#include "beside_program.h"

namespace roomgen::cli {

namespace fs = std::filesystem;

Result<fs::path> find_beside_program(const std::string& name, const std::string& why) {
  std::error_code failed;
  const auto folder = fs::read_symlink("/proc/self/exe", failed).parent_path();
  for (const auto& place : {folder / name, folder / ROOMGEN_MODULE_FOLDER / name})
    if (fs::exists(place, failed)) return place;
  return Error{Error::Kind::unavailable, name + " is missing beside the program: " + why};
}

}  // namespace roomgen::cli
