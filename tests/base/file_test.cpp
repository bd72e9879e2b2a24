#include "roomgen/base/file.h"

#include <fstream>

#include "catch.h"
#include "support/contains.h"
#include "support/temporary_folder.h"

using namespace roomgen;

TEST_CASE("What is written is read back, whatever the bytes") {
  const TemporaryFolder folder;
  std::string bytes;
  for (int i = 0; i < 100000; ++i) bytes += static_cast<char>(i * 31);
  REQUIRE(write_file(folder / "a.bin", bytes));
  const auto read = read_file(folder / "a.bin");
  REQUIRE(read);
  CHECK(*read == bytes);
  REQUIRE(write_file(folder / "empty", ""));
  CHECK(read_file(folder / "empty")->empty());
}

TEST_CASE("Writing replaces the old file and leaves nothing beside it") {
  const TemporaryFolder folder;
  REQUIRE(write_file(folder / "a.json", "a long first version"));
  REQUIRE(write_file(folder / "a.json", "short"));
  CHECK(*read_file(folder / "a.json") == "short");
  CHECK(names_in(folder.path()) == std::vector<std::string>{"a.json"});
}

TEST_CASE("A write that fails at the last moment leaves the old things and no part") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "taken");  // a file cannot take the place of a folder
  REQUIRE(write_file((folder / "taken") / "inside", "kept"));
  const auto written = write_file(folder / "taken", "bytes");
  REQUIRE_FALSE(written);
  CHECK(written.error().kind == Error::Kind::io);
  CHECK(is_one_line(written.error().message));
  CHECK(names_in(folder.path()) == std::vector<std::string>{"taken"});
  CHECK(*read_file((folder / "taken") / "inside") == "kept");
}

TEST_CASE("Writing into a folder that is not there fails and names the file") {
  const TemporaryFolder folder;
  const auto path = (folder / "no") / "such.json";
  const auto written = write_file(path, "bytes");
  REQUIRE_FALSE(written);
  CHECK(written.error().kind == Error::Kind::io);
  CHECK(contains_text(written.error().message, path.string()));
  CHECK(names_in(folder.path()).empty());
}

TEST_CASE("A missing file, a folder and too large a file each say so") {
  const TemporaryFolder folder;
  const auto missing = read_file(folder / "none");
  REQUIRE_FALSE(missing);
  CHECK(missing.error().kind == Error::Kind::not_found);

  const auto directory = read_file(folder.path());
  REQUIRE_FALSE(directory);
  CHECK(directory.error().kind == Error::Kind::io);

  REQUIRE(write_file(folder / "eleven", "eleven byte"));
  CHECK(read_file(folder / "eleven", 11));
  const auto large = read_file(folder / "eleven", 10);
  REQUIRE_FALSE(large);
  CHECK(large.error().kind == Error::Kind::limit);
}

TEST_CASE("A device without an end is not read") {
  const auto endless = read_file("/dev/zero");
  REQUIRE_FALSE(endless);
  CHECK(endless.error().kind == Error::Kind::io);
}
