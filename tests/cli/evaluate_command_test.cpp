#include <nlohmann/json.hpp>

#include "catch.h"
#include "process.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"

namespace {

void solve_into(const TemporaryFolder& folder, const std::string& id, const std::string& problem) {
  std::filesystem::create_directories(folder / id);
  REQUIRE(run({"solve", test_data + "/solver-scenes/" + problem, "-o", folder / (id + "/scene.json")}).code == 0);
}

}  // namespace

TEST_CASE("A room that cannot be read is told, and the others are scored") {
  const TemporaryFolder folder;
  solve_into(folder, "1", "balcony.json");
  solve_into(folder, "3", "bedroom.json");
  std::filesystem::create_directories(folder / "2");
  REQUIRE(roomgen::write_file(folder / "2/scene.json", "{\"format\": \"roomgen-scene\", "));
  REQUIRE(roomgen::write_file(folder / "rows.csv",
                              "ID,Description,ObjCount\n1,a balcony,\n2,a ruin,\n3,a bedroom,\"ge,1,bed\"\n"));
  const auto ended = run({"--json", "evaluate", "--requirements", folder / "rows.csv", "--rooms", folder / ""});
  CHECK(ended.code == 1);
  CHECK(ended.err.find("not scored") != std::string::npos);
  const auto json = roomgen::parse_json(ended.out, "stdout");
  REQUIRE(json);
  CHECK((*json)["rooms"] == 2);
  CHECK((*json)["unscored"][0]["id"] == "2");
}
