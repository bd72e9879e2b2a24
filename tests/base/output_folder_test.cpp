#include "roomgen/base/file.h"

#include <sys/stat.h>
#include <sys/wait.h>

#include <csignal>
#include <thread>

#include "catch.h"
#include "support/contains.h"
#include "support/file_size_limit.h"
#include "support/temporary_folder.h"

using namespace roomgen;

namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

bool is_ours(const fs::path& relative) {
  return relative == "a" || relative == "b" || relative == "sub" || relative == "sub/c";
}

/// Three files that say the same.
Status write_version(const fs::path& folder, const std::string& text) {
  auto output = OutputFolder::open(folder, is_ours);
  if (!output) return output.error();
  for (const auto* name : {"a", "b", "sub/c"})
    if (auto status = output->write(name, text); !status) return status;
  return output->commit();
}

std::string text_of(const fs::path& file) {
  const auto text = read_file(file);
  return text ? *text : text.error().message;
}

void check_version(const fs::path& folder, const std::string& text) {
  for (const auto* name : {"a", "b", "sub/c"}) CHECK(text_of(folder / name) == text);
}

}  // namespace

TEST_CASE("A new folder appears at the commit, with the folders above it") {
  const TemporaryFolder folder;
  const auto room = (folder / "out") / "room";
  {
    auto output = OutputFolder::open(room);
    REQUIRE(output);
    REQUIRE(output->write("sub/c", "text"));
    CHECK_FALSE(fs::exists(room));
    REQUIRE(output->commit());
  }
  CHECK(names_in(folder / "out") == Names{"room"});
  CHECK(names_in(room) == Names{"sub"});
  CHECK(text_of(room / "sub" / "c") == "text");
}

TEST_CASE("Where the working folder is gone a folder in it is refused") {
  const TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::create_directory(folder / "gone");
  fs::current_path(folder / "gone");
  fs::remove(folder / "gone");
  const auto output = OutputFolder::open("room");
  fs::current_path(before);
  REQUIRE_FALSE(output);
  CHECK(output.error().kind == Error::Kind::io);
  CHECK(contains_text(output.error().message, "room: "));
}

TEST_CASE("Without a commit nothing has happened") {
  const TemporaryFolder folder;
  REQUIRE(write_version(folder / "old", "1"));
  for (const auto* name : {"old", "new"}) {
    auto output = OutputFolder::open(folder / name, is_ours);
    REQUIRE(output);
    REQUIRE(output->write("a", "2"));
  }
  CHECK(names_in(folder.path()) == Names{"old"});
  check_version(folder / "old", "1");
}

TEST_CASE("Of the old folder stays what is not ours, and its permissions") {
  const TemporaryFolder folder;
  const auto room = folder / "room";
  REQUIRE(write_version(room, "1"));
  REQUIRE(write_file(room / "notes", "mine"));
  REQUIRE(write_file(room / "sub" / "notes", "mine too"));
  fs::create_directories(room / "pictures" / "empty");
  REQUIRE(write_file(room / "pictures" / "one", "picture"));
  fs::create_symlink("nowhere", room / "link");
  fs::permissions(room, fs::perms(0750));
  auto output = OutputFolder::open(room, is_ours);
  REQUIRE(output);
  REQUIRE(output->write("a", "2"));
  REQUIRE(write_file(room / "late", "came meanwhile"));
  REQUIRE(output->commit());
  output = Error{};  // the owner goes
  CHECK(names_in(room) == Names{"a", "late", "link", "notes", "pictures", "sub"});
  CHECK(names_in(room / "sub") == Names{"notes"});
  CHECK(names_in(room / "pictures") == Names{"empty", "one"});
  CHECK(text_of(room / "a") == "2");
  CHECK(text_of(room / "notes") == "mine");
  CHECK(text_of(room / "sub" / "notes") == "mine too");
  CHECK(text_of(room / "pictures" / "one") == "picture");
  CHECK(fs::read_symlink(room / "link") == "nowhere");
  CHECK(fs::status(room).permissions() == fs::perms(0750));
  CHECK(names_in(folder.path()) == Names{"room"});
}

TEST_CASE("The folder of the program itself is changed file by file") {
  const TemporaryFolder folder;
  const auto room = folder / "room", before = fs::current_path();
  REQUIRE(write_version(room, "1"));
  REQUIRE(write_file(room / "sub" / "notes", "mine"));
  fs::current_path(room);
  {
    auto output = OutputFolder::open(".", is_ours);
    REQUIRE(output);
    REQUIRE(output->write("a", "2"));
    REQUIRE(output->write("sub/d", "2"));
    check_version(room, "1");
    REQUIRE(output->commit());
  }
  CHECK(names_in(".") == Names{"a", "sub"});
  CHECK(names_in("sub") == Names{"d", "notes"});
  CHECK(text_of("a") == "2");
  fs::current_path(before);
}

TEST_CASE("The folder may be given as a link, but links in it are not followed") {
  const TemporaryFolder folder;
  fs::create_directories(folder / "real");
  fs::create_directories(folder / "elsewhere");
  fs::create_directory_symlink("real", folder / "link");
  REQUIRE(write_version(folder / "link", "1"));
  CHECK(fs::is_symlink(folder / "link"));
  check_version(folder / "real", "1");

  fs::remove_all((folder / "real") / "sub");
  fs::create_directory_symlink("../elsewhere", (folder / "real") / "sub");
  fs::remove((folder / "real") / "a");
  fs::create_symlink("../secret", (folder / "real") / "a");
  auto output = OutputFolder::open(folder / "link", is_ours);
  REQUIRE(output);
  for (const auto* name : {"a", "sub/c"}) {
    const auto written = output->write(name, "2");
    REQUIRE_FALSE(written);
    CHECK(contains_text(written.error().message, "or a link to one"));
  }
  CHECK(names_in(folder / "elsewhere").empty());
  CHECK_FALSE(fs::exists(folder / "secret"));
}

TEST_CASE("Devices and folders in place of a file, and files in place of a folder, are refused") {
  const TemporaryFolder folder;
  const auto room = folder / "room";
  fs::create_directories(room / "b");
  REQUIRE(::mkfifo((room / "a").c_str(), 0600) == 0);
  auto output = OutputFolder::open(room, is_ours);
  REQUIRE(output);
  CHECK_FALSE(output->write("a", "2"));
  CHECK_FALSE(output->write("b", "2"));
  REQUIRE(write_file(folder / "file", "kept"));
  const auto opened = OutputFolder::open(folder / "file");
  REQUIRE_FALSE(opened);
  CHECK(contains_text(opened.error().message, "exists and is not a folder"));
  fs::create_symlink("nowhere", folder / "dangling");
  CHECK_FALSE(OutputFolder::open(folder / "dangling"));
}

TEST_CASE("A full disk leaves the old folder whole") {
  const TemporaryFolder folder;
  REQUIRE(write_version(folder / "room", "1"));
  {
    const FileSizeLimit limit(1000);
    CHECK_FALSE(write_version(folder / "room", std::string(2000, 'x')));
  }
  check_version(folder / "room", "1");
  CHECK(names_in(folder.path()) == Names{"room"});
}

TEST_CASE("A writer that is killed at any moment leaves the folder of one version") {
  const TemporaryFolder folder;
  const auto room = folder / "room";
  REQUIRE(write_version(room, "0"));
  REQUIRE(write_file(room / "notes", "mine"));
  for (int kill = 0; kill < 40; ++kill) {
    const pid_t writer = ::fork();
    if (writer == 0)
      for (int version = 0;; ++version)
        if (!write_version(room, std::string(20000, 'x') + std::to_string(version))) ::_exit(1);
    std::this_thread::sleep_for(std::chrono::microseconds(2000 + 373 * kill));
    ::kill(writer, SIGKILL);
    int status = 0;
    ::waitpid(writer, &status, 0);
    CHECK(WIFSIGNALED(status));
    const std::string text = text_of(room / "a");
    INFO(text.substr(0, 80));
    CHECK(text.size() < 21000);
    check_version(room, text);
    CHECK(text_of(room / "notes") == "mine");
  }
  // The next one removes what those left.
  REQUIRE(write_version(room, "last"));
  CHECK(names_in(folder.path()) == Names{"room"});
  CHECK(names_in(room) == Names{"a", "b", "notes", "sub"});
}

TEST_CASE("Of two that begin a folder the first keeps it, and the second says so") {
  const TemporaryFolder folder;
  auto first = OutputFolder::open(folder / "room", is_ours), second = OutputFolder::open(folder / "room", is_ours);
  REQUIRE(first);
  REQUIRE(second);
  REQUIRE(first->write("a", "1"));
  REQUIRE(second->write("a", "2"));
  REQUIRE(first->commit());
  const auto status = second->commit();
  REQUIRE(!status);
  CHECK(contains_text(status.error().message, "somebody else has written it meanwhile"));
  second = Error{};  // the owner goes
  CHECK(text_of(folder / "room" / "a") == "1");
  CHECK(names_in(folder.path()) == Names{"room"});
}

TEST_CASE("A write that fails names the file where it is to be") {
  const TemporaryFolder folder;
  const auto output = OutputFolder::open(folder / "room", is_ours);
  REQUIRE(output);
  const auto status = output->write_with("a", [](const fs::path& now) {
    return Status(Error{Error::Kind::io, now.string() + ": cannot write"});
  });
  REQUIRE(!status);
  CHECK(status.error().message == (folder / "room" / "a").string() + ": cannot write");
  const FileSizeLimit limit(10000);
  const auto full = output->write("a", std::string(50000, 'x'));
  REQUIRE(!full);
  CHECK(full.error().message.starts_with((folder / "room" / "a").string() + ": cannot write"));
}
