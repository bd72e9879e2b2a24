// A disk that fails at any call while a folder of results or a file is written: whole or nothing.
#include "catch.h"
#include "failing_calls.h"
#include "roomgen/base/file.h"
#include "short_of_memory.h"
#include "support/contains.h"
#include "support/temporary_folder.h"

using namespace roomgen;

namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

constexpr const char* files[] = {"a", "b", "sub/c"};

bool is_ours(const fs::path& relative) {
  return relative == "a" || relative == "b" || relative == "sub" || relative == "sub/c";
}

Status write_version(const fs::path& folder, const std::string& text) {
  auto output = OutputFolder::open(folder, is_ours);
  if (!output) return output.error();
  for (const auto* file : files)
    if (auto status = output->write(file, text); !status) return status;
  return output->commit();
}

// All of it or nothing of it, and nothing beside.
void check_version(const fs::path& folder, const std::string& text) {
  for (const auto* file : files) {
    const auto found = read_file(folder / file);
    REQUIRE(found);
    CHECK(*found == text);
  }
}

void check_message(const Status& status, const fs::path& folder) {
  INFO(status.error().message);
  CHECK(is_one_line(status.error().message));
  CHECK(contains_text(status.error().message, folder.string()));
}

// Does the n-th call fail? Then all is as before, or as it should be.
bool try_over_an_older_folder(Call call, std::size_t n, bool lasting) {
  const TemporaryFolder folder;
  const auto room = folder / "room";
  REQUIRE(write_version(room, "old"));
  REQUIRE(write_file(room / "notes", "mine"));
  Status status;
  bool has_failed = false;
  {
    const FailingCalls failing(call, n, lasting);
    status = write_version(room, "new");
    has_failed = failing.has_failed();
  }
  INFO(name(call) << " " << n << (lasting ? " lasting" : "") << ": " << (status ? "done" : status.error().message));
  check_version(room, status ? "new" : "old");
  if (!status) check_message(status, folder.path());
  CHECK(*read_file(room / "notes") == "mine");
  CHECK(names_in(folder.path()) == Names{"room"});
  CHECK(names_in(room) == Names{"a", "b", "notes", "sub"});
  return has_failed;
}

bool try_a_new_folder(Call call, std::size_t n, bool lasting) {
  const TemporaryFolder folder;
  Status status;
  bool has_failed = false;
  {
    const FailingCalls failing(call, n, lasting);
    status = write_version(folder / "room", "new");
    has_failed = failing.has_failed();
  }
  INFO(name(call) << " " << n << (lasting ? " lasting" : "") << ": " << (status ? "done" : status.error().message));
  if (status) {
    check_version(folder / "room", "new");
  } else {
    check_message(status, folder.path());
    CHECK(names_in(folder.path()).empty());
  }
  return has_failed;
}

bool try_a_file(Call call, std::size_t n, bool lasting) {
  const TemporaryFolder folder;
  REQUIRE(write_file(folder / "a", "old"));
  Status status;
  bool has_failed = false;
  {
    const FailingCalls failing(call, n, lasting);
    status = write_file(folder / "a", "new");
    has_failed = failing.has_failed();
  }
  CHECK(*read_file(folder / "a") == (status ? "new" : "old"));
  if (!status) check_message(status, folder.path());
  CHECK(names_in(folder.path()) == Names{"a"});
  return has_failed;
}

// How many calls there were to fail.
template <typename Try>
std::size_t fail_each(Call call, Try attempt) {
  std::size_t n = 0;
  while (attempt(call, n, false)) ++n;
  for (std::size_t k = 0; k < n; ++k) attempt(call, k, true);
  return n;
}

}  // namespace

TEST_CASE("Whichever call fails, an older folder is left whole or replaced whole") {
  std::size_t tried = 0;
  for (const Call call : all_file_calls) tried += fail_each(call, try_over_an_older_folder);
  // Three files are written, made and synced, and the folder exchanged; less would mean that nothing was tried.
  CHECK(tried >= 12);
}

TEST_CASE("Whichever call fails, a new folder is there whole or not at all") {
  std::size_t tried = 0;
  for (const Call call : all_file_calls) tried += fail_each(call, try_a_new_folder);
  CHECK(tried >= 12);
}

TEST_CASE("Whichever call fails, a file has its old bytes or its new ones") {
  std::size_t tried = 0;
  for (const Call call : all_file_calls) tried += fail_each(call, try_a_file);
  CHECK(tried >= 4);
}

TEST_CASE("Wherever memory ends, a folder is of one version, and the next one leaves nothing beside it") {
  const TemporaryFolder folder;
  const auto room = folder / "room";
  constexpr std::size_t stride = 7;
  std::size_t tried = 0;
  for (bool has_failed = true; has_failed; ++tried) {
    REQUIRE(write_version(room, "old"));
    CHECK(names_in(folder.path()) == Names{"room"});
    has_failed = run_short_of_memory(tried * stride, [&] { (void)write_version(room, "new"); });
    INFO("allocation " << tried * stride);
    check_version(room, *read_file(room / "a") == "new" ? "new" : "old");
  }
  CHECK(tried > 20);
}
