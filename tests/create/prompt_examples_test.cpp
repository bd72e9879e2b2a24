// What the prompts show is what the format is.
#include <nlohmann/json.hpp>

#include "base/resource.h"
#include "conversation.h"
#include "roomgen/base/json.h"
#include "roomgen/shape/program.h"

using namespace conversation;

namespace {

std::string prompt(const std::string& name) {
  return std::string(*resource("prompts/" + name + ".md"));
}

std::vector<std::string> fenced(const std::string& text) {
  std::vector<std::string> blocks;
  const std::string open = "```json\n", close = "```";
  for (auto at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
    at += open.size();
    const auto end = text.find(close, at);
    blocks.push_back(text.substr(at, end - at));
    at = end + close.size();
  }
  return blocks;
}

}  // namespace

TEST_CASE("The programs in the prompt are sound and as large as they say") {
  const auto blocks = fenced(prompt("create-generate-system"));
  REQUIRE(blocks.size() == 2);
  const Vec3 sizes[] = {{0.8, 0.8, 0.45}, {0.38, 0.38, 0.45}};
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const auto json = shape::parse_recipe(blocks[k], "prompt");
    REQUIRE(json);
    const auto program = shape::instantiate(*json);
    INFO((program ? "" : program.error().message));
    REQUIRE(program);
    const auto shape = shape::evaluate(*program);
    REQUIRE(shape);
    const auto box = shape::bounds(*shape);
    CHECK(std::abs(box.low.z()) < 0.001);
    CHECK(std::abs(box.size().z() - sizes[k].z()) < 0.001);
    CHECK(std::abs(box.size().x() - sizes[k].x()) < 0.03);
  }
}

TEST_CASE(
    "The prompt names every pattern, and its answers of decomposing and meshing are readable") {
  const std::string text = prompt("create-generate-system");
  for (const auto& pattern : shape::pattern_names()) CHECK(contains_text(text, pattern));
  for (const auto& motif : shape::motif_names()) CHECK(contains_text(text, motif));

  Conversation decomposing({reply_saying(prompt("create-decompose-system"))});
  const auto objects = decomposing.maker->decompose("a bar stool");
  REQUIRE(objects);
  CHECK(objects->front().noun == "bar stool");
  CHECK(objects->front().parts.size() == 3);
  CHECK(decomposing.maker->take_notes().empty());

  ModelMakerOptions options;
  options.variant = Variant::direct;
  const std::string mesh = prompt("create-mesh-system");
  Conversation meshing({reply_saying(mesh.substr(mesh.find("A board of")))}, options);
  const auto shape = meshing.maker->generate_mesh({});
  REQUIRE(shape);
  CHECK(shape->bodies.front().label == "seat");
  CHECK(meshing.maker->take_notes().empty());
}

TEST_CASE("Every solid and operation that the prompt shows is read") {
  const std::string text = prompt("create-generate-system");
  int solids = 0, operations = 0;
  for (std::size_t at = 0, end; at < text.size(); at = end + 1) {
    end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    const auto colon = line.find("\": {");
    if (line.rfind("- \"", 0) != 0 || colon == std::string::npos) continue;
    if (contains_text(line, "...")) continue;
    int depth = 0;
    std::size_t close = colon + 3;
    do {
      depth += line[close] == '{' ? 1 : line[close] == '}' ? -1 : 0;
    } while (++close < line.size() && depth > 0);
    INFO(line);
    const Json part = Json::parse("{\"name\": \"a\", " + line.substr(2, close - 2) + "}");
    CHECK(shape::instantiate({{"format", "roomgen-shape"}, {"components", Json::array({part})}}));
    ++solids;
  }
  CHECK(solids >= 12);
  for (const char* operation :
       {R"({"mirror": "x"})", R"({"array": {"count": 5, "step": [0, 0, 0.3]}})",
        R"({"radial": {"count": 4}})", R"({"cut": {"point": [0, 0, 0.1], "normal": [0, 0, 1]}})",
        R"({"center": "xy"})", R"({"ground": true})", R"({"join": true})"}) {
    CHECK(contains_text(text, operation));
    ++operations;
  }
  CHECK(operations == 7);
}
