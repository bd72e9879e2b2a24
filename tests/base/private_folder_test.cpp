#include "base/private_folder.h"

#include <filesystem>

#include "catch.h"
#include "support/temporary_folder.h"

using namespace roomgen;
namespace fs = std::filesystem;

TEST_CASE("Where a folder can be made is tried, and nothing is left of it") {
  const TemporaryFolder folder;
  CHECK(may_write_below(folder.path()));
  CHECK(may_write_below(folder.path() / "a" / "b"));
  CHECK(fs::is_empty(folder.path()));
  // Which root may write, by its mode.
  if (fs::exists("/proc/self")) CHECK_FALSE(may_write_below("/proc/nowhere/.cache/roomgen"));
}
