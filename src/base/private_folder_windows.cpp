#include "private_folder.h"
#include "roomgen/base/file.h"

namespace roomgen {

namespace fs = std::filesystem;

bool may_write_below(const fs::path&) { return true; }

// The temporary folder of Windows is the user's own.
Result<fs::path> private_folder(const std::string& name) {
  std::error_code failed;
  const fs::path folder = fs::temp_directory_path(failed) / name;
  if (auto status = make_folder(folder); !status) return status.error();
  return folder;
}

}  // namespace roomgen
