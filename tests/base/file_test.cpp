#include "roomgen/base/file.h"

#include <algorithm>
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

TEST_CASE("What a killed run left of a file goes with the next one written there, and nothing else does") {
  const TemporaryFolder folder;
  const std::vector<std::string> others = {".notes.part", ".a.json.0123456789abcdeg.part", "a.json.0123456789abcdef.part"};
  for (const auto& name : others) std::ofstream(folder / name) << "mine";
  std::ofstream(folder / ".thing.glb.0123456789abcdef.part") << "half of a";
  REQUIRE(write_file(folder / "a.json", "{}"));
  std::vector<std::string> expected = others;
  expected.push_back("a.json");
  std::sort(expected.begin(), expected.end());
  CHECK(names_in(folder.path()) == expected);
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

TEST_CASE("Links, folders and devices are no files to write: refused, not followed, not replaced") {
  const TemporaryFolder folder;
  REQUIRE(write_file(folder / "target", "kept"));
  std::filesystem::create_symlink("target", folder / "link");
  std::filesystem::create_symlink("nowhere", folder / "dangling");
  for (const auto& path : {folder / "link", folder / "dangling", std::filesystem::path("/dev/null")}) {
    const auto written = write_file(path, "bytes");
    REQUIRE_FALSE(written);
    CHECK(written.error().kind == Error::Kind::io);
    CHECK(contains_text(written.error().message, path.string() + ": cannot write: it is"));
    CHECK_FALSE(AppendedFile::open(path));
  }
  CHECK(*read_file(folder / "target") == "kept");
  CHECK(names_in(folder.path()) == std::vector<std::string>{"dangling", "link", "target"});
}

TEST_CASE("What another library writes replaces the old file as a whole, or not at all") {
  const TemporaryFolder folder;
  REQUIRE(write_file(folder / "a.db", "old"));
  const auto failed = replace_file(folder / "a.db", [](const auto& aside) -> Status {
    std::ofstream(aside) << "half";
    return Error{Error::Kind::io, "no more"};
  });
  REQUIRE_FALSE(failed);
  CHECK(failed.error().message == "no more");
  CHECK(*read_file(folder / "a.db") == "old");
  REQUIRE(replace_file(folder / "a.db", [](const auto& aside) {
    std::ofstream(aside) << "new";
    return Status();
  }));
  CHECK(*read_file(folder / "a.db") == "new");
  CHECK(names_in(folder.path()) == std::vector<std::string>{"a.db"});
}

TEST_CASE("An appended file goes on where it ended") {
  const TemporaryFolder folder;
  REQUIRE(AppendedFile::open(folder / "lines")->append("one\n"));
  const auto file = AppendedFile::open(folder / "lines");
  REQUIRE(file);
  REQUIRE(file->append("two\n"));
  CHECK(*read_file(folder / "lines") == "one\ntwo\n");
}
