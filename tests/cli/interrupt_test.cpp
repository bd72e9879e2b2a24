#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "catch.h"
#include "process.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"

TEST_CASE("Ctrl-C leaves the room placed so far, marked as incomplete, and exits with 130") {
  // A room that can never be whole, and more rounds than anybody waits for.
  const TemporaryFolder folder;
  const std::string scene = folder / "scene.json";
  Process process({"solve", ROOMGEN_TEST_DATA "/rooms/91-contradiction.json", "-o", scene, "--rounds",
                   "1000000"});
  std::this_thread::sleep_for(std::chrono::seconds(2));  // until it is at work
  process.interrupt();
  const auto ended = process.wait();
  INFO(ended.err);
  CHECK(ended.code == 130);
  CHECK(names_in(folder.path()) == std::vector<std::string>{"scene.json"});
  const auto text = roomgen::read_file(scene);
  REQUIRE(text);
  const auto json = roomgen::parse_json(*text, "scene.json");
  REQUIRE(json);
  CHECK((*json)["incomplete"] == true);
  CHECK((*json)["objects"].size() == 3);
}
