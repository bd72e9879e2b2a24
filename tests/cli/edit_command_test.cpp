#include <nlohmann/json.hpp>

#include "catch.h"
#include "process.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "support/contains.h"

namespace {

namespace fs = std::filesystem;

const char* const two_chairs = R"({"format": "roomgen-scene", "version": 1,
  "room": {"type": "study", "polygon": [[0,0],[4,0],[4,4],[0,4]], "height": 2.7,
           "openings": [{"id": "door-0", "type": "door", "wall": 0, "from": 0.4, "to": 1.3}]},
  "objects": [
    {"id": "stool-0", "category": "stool", "asset": null, "size": [0.4,0.4,0.5], "position": [1,2,0], "yaw_deg": 0},
    {"id": "stool-1", "category": "stool", "asset": null, "size": [0.4,0.4,0.5], "position": [3,2,0], "yaw_deg": 0}]})";

fs::path scene_in(const TemporaryFolder& folder) {
  const fs::path file = folder / "scene.json";
  REQUIRE(roomgen::write_file(file, two_chairs));
  return file;
}

std::string bytes_of(const fs::path& file) { return *roomgen::read_file(file); }

}  // namespace

TEST_CASE("edit exits with 0 done, 1 not possible, 2 not understood, and in 1 and 2 nothing changes") {
  const TemporaryFolder folder;
  const fs::path scene = scene_in(folder);
  const auto edit = [&](const std::string& what) { return run({"edit", scene, what, "--no-default-libraries"}); };
  CHECK(failed_in_one_line(edit("move the left stool 5 m to the left"), 1));
  CHECK(failed_in_one_line(edit("remove the stool"), 2));
  CHECK(failed_in_one_line(edit("sing a song"), 2));
  CHECK(failed_in_one_line(run({"edit", scene, "--op", R"({"do": "fly"})"}), 2));
  CHECK(failed_in_one_line(run({"edit", scene, "--op", "{"}), 2));
  CHECK(bytes_of(scene) == two_chairs);
  const auto done = edit("move the left stool 50 cm to the right");
  CHECK(done.code == 0);
  CHECK(contains_text(done.out, "stool-0 moved 0.5 m"));
  CHECK(contains_text(bytes_of(scene), "1.5"));
}

TEST_CASE("undo, redo, history, branch and diff follow an edited room") {
  const TemporaryFolder folder;
  const fs::path scene = scene_in(folder);
  REQUIRE(run({"edit", scene, "--op", R"({"do": "lock", "objects": ["stool-0"]})"}).code == 0);
  REQUIRE(run({"edit", scene, "--op", R"([{"do": "shift", "object": "stool-1", "by": [0,1,0]}, {"do": "turn", "object": "stool-1", "by_deg": 90}])"}).code == 0);
  const std::string last = bytes_of(scene);
  CHECK(contains_text(run({"diff", scene}).out, "stool-1 moved 1 m"));
  CHECK(contains_text(run({"diff", scene, "1", "2"}).out, "stool-0 is locked"));
  CHECK(contains_text(run({"history", scene}).out, "*    3  main"));
  CHECK(run({"undo", scene, "-n", "2"}).code == 0);
  CHECK(bytes_of(scene) == two_chairs);
  CHECK(failed_in_one_line(run({"undo", scene}), 1));
  CHECK(run({"branch", scene, "other", "--at", "2"}).code == 0);
  CHECK(contains_text(run({"branch", scene}).out, "* other"));
  CHECK(run({"branch", scene, "main"}).code == 0);
  CHECK(run({"redo", scene, "-n", "9"}).code == 0);
  CHECK(bytes_of(scene) == last);
}
