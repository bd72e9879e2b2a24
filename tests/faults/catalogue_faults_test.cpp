// A disk that fails at any call while a library is indexed: it is open, or the next who opens it has it.
#include "catch.h"
#include "decode/meshes.h"
#include "failing_calls.h"
#include "roomgen/assets/catalogue.h"
#include "roomgen/base/file.h"
#include "support/contains.h"
#include "support/temporary_folder.h"

using namespace roomgen;

namespace {

namespace fs = std::filesystem;

// In this process: the calls of the one that reads meshes are no files.
Result<std::unique_ptr<assets::Catalogue>> open_library(const TemporaryFolder& folder) {
  assets::CatalogueOptions options;
  options.libraries = {folder / "things"};
  options.cache_dir = folder / "cache";
  options.trusted = true;
  return assets::open_catalogue(options);
}

std::size_t parts_in(const fs::path& cache) {
  std::size_t count = 0;
  if (fs::exists(cache))
    for (const auto& name : names_in(cache)) count += name.ends_with(".part") ? 1 : 0;
  return count;
}

void make_library(const TemporaryFolder& folder) {
  fs::create_directories(folder / "things");
  REQUIRE(write_file((folder / "things") / "box.obj", cube_obj()));
}

// With an index that another version of the library left, or without one.
bool try_call(Call call, std::size_t n, bool lasting, bool with_older) {
  const TemporaryFolder folder;
  make_library(folder);
  if (with_older) {
    REQUIRE(open_library(folder));
    REQUIRE(write_file((folder / "things") / "crate.obj", cube_obj() + "\n"));
  }
  Status status;
  bool has_failed = false;
  {
    const FailingCalls failing(call, n, lasting);
    const auto catalogue = open_library(folder);
    if (!catalogue) status = catalogue.error();
    has_failed = failing.has_failed();
  }
  INFO(name(call) << " " << n << (lasting ? " lasting" : "") << ": " << (status ? "done" : status.error().message));
  if (!status) CHECK(is_one_line(status.error().message));
  CHECK(parts_in(folder / "cache") == 0);
  const auto again = open_library(folder);
  REQUIRE(again);
  const auto all = (*again)->all();
  REQUIRE(all);
  CHECK(all->size() == (with_older ? 2 : 1));
  return has_failed;
}

}  // namespace

TEST_CASE("Whichever call fails, the next one who opens a library has it whole") {
  std::size_t tried = 0;
  for (const bool with_older : {false, true})
    for (const Call call : all_file_calls) {
      std::size_t n = 0;
      while (try_call(call, n, false, with_older)) ++n;
      for (std::size_t k = 0; k < n; ++k) try_call(call, k, true, with_older);
      tried += n;
    }
  CHECK(tried >= 20);
}
