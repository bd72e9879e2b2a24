#include <filesystem>

#include "catch.h"
#include "mcp/root_folder.h"
#include "roomgen/base/file.h"
#include "support/contains.h"
#include "support/error_of.h"
#include "support/temporary_folder.h"

using roomgen::mcp::RootFolder;
namespace fs = std::filesystem;

namespace {

/// A root with a room and, beside the root, what nobody may see.
struct Place {
  Place() {
    for (const fs::path folder : {"root/room", "root/.hidden", "root/a/b", "outside"}) {
      fs::create_directories(files / folder);
      REQUIRE(roomgen::write_file(files / folder / "scene.json", "{}"));
    }
  }
  RootFolder root() const { return *RootFolder::open(files / "root"); }

  TemporaryFolder files;
};

}  // namespace

TEST_CASE("Paths below the root are found, whether they are there or not") {
  const Place place;
  const auto root = place.root();
  const fs::path real = fs::canonical(place.files / "root");
  CHECK(*root.find("room") == real / "room");
  CHECK(*root.find("new/room") == real / "new/room");
  CHECK(*root.find("room/../new") == real / "new");
  CHECK(*root.find((real / "room").string()) == real / "room");
  CHECK(root.name_of(real / "a/b") == "a/b");
}

TEST_CASE("Paths that lead out of the root are refused, however they are written") {
  const Place place;
  const auto root = place.root();
  fs::create_directory_symlink(place.files / "outside", place.files / "root/link");
  fs::create_symlink(place.files / "nowhere", place.files / "root/dangling");
  fs::create_directory_symlink("..", place.files / "root/up");
  const std::vector<std::string> paths = {
      "..", "../outside", "room/../../outside", "new/../../outside", "/etc/passwd", "link", "link/new", "up/outside",
      "dangling", "dangling/x", (place.files / "outside").string(), (place.files / "root2").string(), "",
      std::string("room\0x", 6), std::string(5000, 'a')};
  for (const auto& path : paths) {
    INFO(path);
    CHECK_FALSE(root.find(path));
  }
  CHECK(contains_text(root.find("../outside").error().message, "leads out of the root folder"));
}

TEST_CASE("A link within the root is followed") {
  const Place place;
  fs::create_directory_symlink(place.files / "root/room", place.files / "root/same");
  CHECK(*place.root().find("same/x") == fs::canonical(place.files / "root") / "room/x");
}

TEST_CASE("A room is known by its folder or its scene, and its files may not be links out of the root") {
  const Place place;
  const auto root = place.root();
  const fs::path scene = fs::canonical(place.files / "root") / "room/scene.json";
  CHECK(*root.find_scene("room") == scene);
  CHECK(*root.find_scene("room/scene.json") == scene);
  CHECK(contains_text(root.find_scene("rom").error().message, "rooms are: a/b, room"));
  fs::create_symlink(place.files / "outside/scene.json", place.files / "root/room/scene.journal");
  CHECK(contains_text(root.find_scene("room").error().message, "leads out of the root folder"));
}

TEST_CASE("Rooms are listed without hidden folders, and links are not entered") {
  const Place place;
  fs::create_directory_symlink("..", place.files / "root/up");
  CHECK(place.root().rooms(10) == std::vector<std::string>{"a/b", "room"});
  CHECK(place.root().rooms(1) == std::vector<std::string>{"a/b"});
}

TEST_CASE("A root that is no folder is told") {
  const Place place;
  CHECK_FALSE(RootFolder::open(place.files / "none"));
  CHECK_FALSE(RootFolder::open(place.files / "root/room/scene.json"));
}
