#include "roomgen/create/maker.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "roomgen/base/json.h"
#include "support/contains.h"

using namespace roomgen;
using namespace roomgen::create;

namespace {

Description bar_stool() {
  Description stool;
  stool.prompt = "two tall bar stools with three slanted brass legs and no armrests";
  stool.noun = "bar stool";
  stool.kind = "stool";
  stool.approximate = true;
  stool.count = 2;
  stool.style = "industrial";
  stool.material = "oak";
  stool.color = "white";
  stool.size = Vec3(0.4, std::nan(""), 0.75);
  stool.scale = Vec3(1.0, 1.0, 1.2);
  PartWish leg;
  leg.label = "leg";
  leg.count = 3;
  leg.shape = "round";
  leg.construction = "turned";
  leg.material = "brass";
  leg.color = "gold";
  leg.lean = 8.5;
  leg.course = Course::s_curve;
  leg.strength = Strength::pronounced;
  leg.direction = "outward";
  leg.size = Vec3(0.03, 0.03, 0.71);
  leg.scale = Vec3(1.5, 1.5, 1.0);
  leg.touches = {"seat", "floor"};
  PartWish armrest;
  armrest.label = "armrest";
  armrest.count = 0;
  stool.parts = {leg, armrest};
  return stool;
}

std::string refusal(const std::string& text) {
  const auto description = description_from_json(Json::parse(text), "wish.json");
  INFO(text);
  REQUIRE_FALSE(description);
  return description.error().message;
}

}  // namespace

TEST_CASE("A description survives its file") {
  const Json json = to_json(bar_stool());
  const auto read = description_from_json(json, "wish.json");
  INFO((read ? "" : read.error().message));
  REQUIRE(read);
  CHECK(to_json(*read) == json);
  CHECK(read->count == 2);
  CHECK(read->approximate);
  CHECK(std::abs(read->size->z() - 0.75) < 1e-9);
  CHECK(std::isnan(read->size->y()));
  REQUIRE(read->parts.size() == 2);
  CHECK(read->parts[0].course == Course::s_curve);
  CHECK(read->parts[0].strength == Strength::pronounced);
  CHECK(*read->parts[0].lean == 8.5);
  CHECK(read->parts[0].touches == std::vector<std::string>{"seat", "floor"});
  CHECK(read->parts[1].count == 0);
}

TEST_CASE("Sizes of a description's file are centimetres, and null where nothing was said") {
  const Json json = to_json(bar_stool());
  CHECK(json["size_cm"] == Json::parse("[40.0, null, 75.0]"));
  CHECK(json["parts"][0]["size_cm"] == Json::parse("[3.0, 3.0, 71.0]"));
  CHECK_FALSE(json["parts"][1].contains("size_cm"));
}

TEST_CASE("What is wrong in a description's file is named with its place") {
  CHECK(contains_text(refusal(R"([])"), "wish.json"));
  CHECK(contains_text(refusal(R"({})"), "/object"));
  CHECK(contains_text(refusal(R"({"object": "x", "legs": 4})"), "legs"));
  CHECK(contains_text(refusal(R"({"object": "x", "count": 201})"), "/count"));
  CHECK(contains_text(refusal(R"({"object": "x", "count": 1.5})"), "/count"));
  CHECK(contains_text(refusal(R"({"object": "x", "size_cm": [1, 2]})"), "/size_cm"));
  CHECK(contains_text(refusal(R"({"object": "x", "size_cm": [1, 2, 100000]})"), "/size_cm/2"));
  CHECK(contains_text(refusal(R"({"object": "x", "size_cm": "big"})"), "/size_cm"));
  CHECK(contains_text(refusal(R"({"object": "x", "scale": [0, 1, 1]})"), "/scale"));
  CHECK(contains_text(refusal(R"({"object": "x", "parts": [{}]})"), "/parts/0/label"));
  CHECK(contains_text(refusal(R"({"object": "x", "parts": [{"label": "leg", "count": -1}]})"),
                      "/parts/0/count"));
  CHECK(contains_text(
      refusal(R"({"object": "x", "parts": [{"label": "leg", "course": "zigzag"}]})"), "s-curve"));
  CHECK(contains_text(refusal(R"({"object": "x", "parts": [7]})"), "/parts/0"));
  CHECK(contains_text(
      refusal(R"({"object": "x", "parts": [{"label": "leg", "touches": ["seat", 3]}]})"),
      "/parts/0/touches/1"));
  CHECK(contains_text(refusal(R"({"object": ")" + std::string(101, 'x') + R"("})"), "/object"));
}
