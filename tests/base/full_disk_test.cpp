// A disk that fills up while a file is written: by a limit on the size of files, which needs no rights,
// and on a small file system in memory, where mounting is permitted.
#include <sys/mount.h>

#include "catch.h"
#include "roomgen/base/file.h"
#include "support/contains.h"
#include "support/file_size_limit.h"
#include "support/temporary_folder.h"

using namespace roomgen;

namespace {

class SmallDisk {
 public:
  explicit SmallDisk(const std::filesystem::path& at) : at_(at) {
    mounted_ = ::mount("tmpfs", at.c_str(), "tmpfs", 0, "size=64k") == 0;
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() {
    if (mounted_) ::umount(at_.c_str());
  }
  bool mounted() const { return mounted_; }

 private:
  std::filesystem::path at_;
  bool mounted_ = false;
};

void check_that_a_large_write_fails_cleanly(const std::filesystem::path& folder) {
  const Status written = write_file(folder / "scene.json", std::string(200000, 'x'));
  REQUIRE_FALSE(written);
  CHECK(written.error().kind == Error::Kind::io);
  CHECK(is_one_line(written.error().message));
  CHECK(contains_text(written.error().message, "scene.json: cannot write"));
  CHECK(names_in(folder) == std::vector<std::string>{"scene.json"});
  CHECK(*read_file(folder / "scene.json") == "the old room");
}

}  // namespace

TEST_CASE("A file that cannot grow leaves the old one whole and no part") {
  const TemporaryFolder folder;
  REQUIRE(write_file(folder / "scene.json", "the old room"));
  const FileSizeLimit limit(10000);
  check_that_a_large_write_fails_cleanly(folder.path());
}

TEST_CASE("A full disk leaves the old file whole and no part") {
  const TemporaryFolder folder;
  const SmallDisk disk(folder.path());
  if (!disk.mounted()) {
    WARN("skipped: mounting a small file system is not permitted here");
    return;
  }
  REQUIRE(write_file(folder / "scene.json", "the old room"));
  check_that_a_large_write_fails_cleanly(folder.path());
}
