#include <nlohmann/json.hpp>

#include "catch.h"
#include "mcp/resources.h"
#include "roomgen/base/file.h"
#include "support/temporary_folder.h"

using namespace roomgen::mcp;
namespace fs = std::filesystem;

namespace {

const char* const scene = R"({"format": "roomgen-scene", "version": 1, "prompt": "a study",
  "room": {"type": "study", "polygon": [[0,0],[4,0],[4,4],[0,4]], "height": 2.7, "openings": []}, "objects": []})";

}  // namespace

TEST_CASE("A room's scene and ledger are read by their addresses, and nothing else is") {
  const TemporaryFolder folder;
  fs::create_directories(folder / "my room");
  REQUIRE(roomgen::write_file(folder / "my room/scene.json", scene));
  REQUIRE(roomgen::write_file(folder / "secret.txt", "x"));
  const auto root = *RootFolder::open(folder.path());
  const auto listed = list_resources(root);
  REQUIRE(listed.size() == 2);
  CHECK(listed[0]["uri"] == "roomgen:///my%20room/scene.json");
  CHECK(*read_resource(root, listed[0]["uri"]) == scene);
  const auto ledger = roomgen::parse_json(*read_resource(root, listed[1]["uri"]), "ledger");
  REQUIRE(ledger);
  CHECK((*ledger)["prompt"] == "a study");
  CHECK((*ledger)["requirements"].is_array());
  for (const std::string uri :
       {"", "roomgen:///", "roomgen:///secret.txt", "file:///etc/passwd", "roomgen:///../x/scene.json",
        "roomgen:///%2e%2e/scene.json", "roomgen:///my%2/scene.json", "roomgen:///my%20room/scene.glb"}) {
    INFO(uri);
    CHECK_FALSE(read_resource(root, uri));
  }
}

TEST_CASE("Any path survives its way through an address") {
  std::string all;
  for (int byte = 1; byte < 256; ++byte) all += static_cast<char>(byte);
  CHECK(*percent_decoded(percent_encoded(all)) == all);
  CHECK(percent_encoded("a b/ü") == "a%20b/%C3%BC");
}
