#include "shape/drawing.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/random.h"
#include "catch.h"
#include "roomgen/base/json.h"
#include "roomgen/shape/evaluate.h"
#include "roomgen/shape/program.h"
#include "shape/letters.h"
#include "shape/motifs.h"
#include "support/contains.h"

using namespace roomgen;
using namespace roomgen::shape;

namespace {

Json drawing_of(const std::string& shapes) {
  return Json::parse(R"({"ground": "#ffffff", "shapes": [)" + shapes + "]}");
}

std::string fault(const Json& drawing) {
  const Json component = {{"name", "a"}, {"picture", {{"size", {1, 1}}, {"drawing", drawing}}}};
  const auto program =
      read_program({{"format", "roomgen-shape"}, {"components", Json::array({component})}}, "test");
  return program ? "" : program.error().message;
}

// The share of the picture that is darker than half.
double dark_share(const Image& image) {
  double dark = 0.0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) dark += 1.0 - image.pixels[i] / 255.0;
  return dark / (image.width * image.height);
}

// 16 by 16 means of each channel.
std::vector<double> coarse(const Image& image) {
  constexpr int cells = 16;
  std::vector<double> sums(cells * cells * 3, 0.0);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int k = 0; k < 3; ++k)
        sums[static_cast<std::size_t>(
            (y * cells / image.height * cells + x * cells / image.width) * 3 + k)] +=
            image.at(x, y)[k];
  for (auto& sum : sums) sum *= cells * cells / static_cast<double>(image.width * image.height);
  return sums;
}

double distance_of(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
  return sum / static_cast<double>(a.size());
}

Json random_shape(Random& random) {
  const auto number = [&](double low, double high) { return rounded(random.uniform(low, high)); };
  const auto points = [&](int count) {
    Json list = Json::array();
    for (int k = 0; k < count; ++k) {
      const double x = number(-1, 2), y = number(-1, 2);
      list.push_back({x, y});
    }
    return list;
  };
  Json shape = {{"fill", random.chance(0.5) ? "navy" : "#c8443a"}, {"opacity", number(0, 1)}};
  switch (random.integer(0, 5)) {
    case 0:
      shape["polygon"] = points(random.integer(3, 9));
      break;
    case 1:
      shape["curve"] = points(random.integer(3, 9));
      break;
    case 2:
      shape["circle"] = number(0.01, 0.5);
      break;
    case 3:
      shape["rectangle"] = {number(0.01, 1), number(0.01, 1)};
      break;
    case 4:
      shape["text"] = "ABC 123\nxyz?";
      break;
    default:
      shape["use"] = random.pick(motif_names());
  }
  const double x = number(-1, 2), y = number(-1, 2);
  shape["at"] = {x, y};
  shape["turn"] = number(-200, 200);
  if (random.chance(0.3)) shape["stroke"] = "black";
  if (random.chance(0.3)) shape["mirror"] = true;
  if (random.chance(0.2)) shape["repeat"] = {{"count", 5}, {"turn", number(0, 90)}};
  if (random.chance(0.2)) shape["scatter"] = {{"count", 9}, {"turn", 90}};
  return shape;
}

// How many stretches of x the triangles cover.
int stretches(const Mesh& mesh) {
  std::vector<std::pair<float, float>> spans;
  for (const auto& triangle : mesh.triangles) {
    const auto [low, high] =
        std::minmax({mesh.positions[triangle[0]].x(), mesh.positions[triangle[1]].x(),
                     mesh.positions[triangle[2]].x()});
    spans.emplace_back(low, high);
  }
  std::sort(spans.begin(), spans.end());
  int count = 0;
  float end = -1e9f;
  for (const auto& [low, high] : spans) {
    if (low > end) ++count;
    end = std::max(end, high);
  }
  return count;
}

Mesh text_mesh_of(const Json& text) {
  const auto program =
      read_program({{"format", "roomgen-shape"},
                    {"components", Json::array({Json{{"name", "a"}, {"text", text}}})}},
                   "test");
  REQUIRE(program);
  const auto shape = evaluate(*program);
  INFO((shape ? "" : shape.error().message));
  REQUIRE(shape);
  return shape->bodies.front().mesh;
}

}  // namespace

TEST_CASE("Areas cover what geometry says, wherever and however they are drawn") {
  const struct {
    std::string shapes;
    double share;
  } cases[] = {
      {R"({"circle": 0.3, "at": [0.5, 0.5], "fill": "#000"})", pi * 0.09},
      {R"({"rectangle": [0.5, 0.2], "at": [0.4, 0.6], "turn": 30, "fill": "#000"})", 0.1},
      {R"({"polygon": [[0, 0], [1, 0], [0, 1]], "fill": "#000"})", 0.5},
      {R"({"line": [[0.2, 0.5], [0.8, 0.5]], "stroke": "#000", "width": 0.1})", 0.06 + pi * 0.0025},
      {R"({"circle": 0.1, "at": [0.2, 0], "fill": "#000", "repeat": {"count": 2, "step": [0, 0.5]}})",
       1.5 * pi * 0.01},
      {R"({"group": [{"circle": 0.1, "at": [0.25, 0.5], "fill": "#000", "mirror": true}], "at": [0.5, 0]})",
       2 * pi * 0.01},
      {R"({"circle": 0.3, "at": [0.5, 0.5], "fill": "#000", "opacity": 0.5})", 0.5 * pi * 0.09}};
  for (const auto& one : cases) {
    INFO(one.shapes);
    const Json drawing = drawing_of(one.shapes);
    REQUIRE(fault(drawing).empty());
    const Image image = paint_drawing(drawing.dump(), 0, 1.0);
    CHECK(dark_share(image) == Approx(one.share).margin(0.002));
    // The square lies in the middle, its side the shorter one.
    if (one.share < 0.3)
      CHECK(dark_share(paint_drawing(drawing.dump(), 0, 2.0)) <= one.share + 0.002);
  }
}

TEST_CASE("Random drawings are painted, and equal ones equally") {
  Random random(7);
  for (int round = 0; round < 25; ++round) {
    Json drawing = {{"ground", {"cream", "#103050"}}, {"shapes", Json::array()}};
    for (int k = random.integer(1, 8); k > 0; --k)
      drawing["shapes"].push_back(random_shape(random));
    if (random.chance(0.3)) drawing["colors"] = "ink";
    INFO(drawing.dump());
    CHECK(fault(drawing) == "");
    const double aspect = random.uniform(0.2, 5.0);
    const Image image = paint_drawing(drawing.dump(), 3, aspect);
    CHECK(std::max(image.width, image.height) == 512);
    CHECK(image.pixels == paint_drawing(drawing.dump(), 3, aspect).pixels);
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) REQUIRE(image.pixels[i] == 255);
  }
}

TEST_CASE("What is wrong with a drawing is said, and where") {
  const std::pair<const char*, const char*> cases[] = {
      {R"({"fill": "red"})", "/shapes/0: no shape"},
      {R"({"circle": 0.1})", "nothing to paint with"},
      {R"({"circle": 0.1, "fill": "rdd"})", "did you mean \"red\""},
      {R"({"circle": -1, "fill": "red"})", "/shapes/0/circle"},
      {R"({"line": [[0, 0], [1, 1]], "fill": "red"})", "\"stroke\""},
      {R"({"curve": [[0, 0], [0, 0], [0, 0]], "fill": "red"})", "/shapes/0/curve"},
      {R"({"use": "whael"})", "did you mean \"whale\""},
      {R"({"text": "   ", "fill": "red"})", "no letter"},
      {R"({"circle": 0.1, "fill": "red", "repeat": {"count": 9999}})", "/repeat/count"},
      {R"({"circle": "w", "fill": "red"})", "formulas belong in recipes"},
      {R"({"circle": 0.1, "fil": "red"})", "fil"},
      {R"({"group": [{"group": [{"use": "crane", "colors": "inc"}]}]})", "no palette"}};
  for (const auto& [shapes, message] : cases) {
    INFO(shapes);
    const std::string told = fault(drawing_of(shapes));
    INFO(told);
    CHECK(contains_text(told, message));
    CHECK(contains_text(told, "/components/0/picture/drawing"));
  }
  // What multiplies is bounded.
  Json deep = {{"circle", 0.001}, {"fill", "red"}};
  for (int k = 0; k < 4; ++k)
    deep = {{"group", Json::array({deep})}, {"scatter", {{"count", 500}}}};
  CHECK_FALSE(fault({{"shapes", Json::array({deep})}}).empty());
  Json nested = {{"circle", 0.001}, {"fill", "red"}};
  for (int k = 0; k < 12; ++k) nested = {{"group", Json::array({nested})}};
  CHECK(contains_text(fault({{"shapes", Json::array({nested})}}), "in one another"));
}

TEST_CASE("Every motif shows something of its own, whatever the shape of the picture") {
  const auto names = motif_names();
  REQUIRE(names.size() >= 45);
  const std::vector<double> aspects = {0.6, 1.0, 1.7};
  std::vector<std::vector<double>> grounds, seen;
  for (const double aspect : aspects)
    grounds.push_back(coarse(paint_drawing(R"({"ground": "#ff00ff", "shapes": []})", 0, aspect)));
  for (const auto& name : names) {
    INFO(name);
    Json own = {{"ground", (*find_motif(name)->drawing)["ground"]},
                {"shapes", (*find_motif(name)->drawing)["shapes"]}};
    CHECK(fault(own) == "");
    const Json drawing = {{"ground", "#ff00ff"}, {"shapes", {{{"use", name}}}}};
    for (std::size_t k = 0; k < grounds.size(); ++k) {
      auto shown = coarse(paint_drawing(drawing.dump(), 0, aspects[k]));
      CHECK(distance_of(shown, grounds[k]) > 5.0);
      if (aspects[k] == 1.0) seen.push_back(std::move(shown));
    }
    for (std::size_t k = 0; k + 1 < seen.size(); ++k) {
      INFO(names[k]);
      CHECK(distance_of(seen[k], seen.back()) > 5.0);
    }
  }
}

TEST_CASE("Motifs and palettes are found in the words of people") {
  CHECK(motifs_in("a poster with two cranes over the mountains") ==
        std::vector<std::string>{"crane", "mountains"});
  CHECK(motifs_in("an antique star map") == std::vector<std::string>{"star chart"});
  CHECK(motifs_in("a rose gold frame").empty());
  CHECK(motifs_in("a wooden chair").empty());
  CHECK(palette_in("Japanese scroll") == "ink");
  CHECK(text_in("a chalkboard menu").starts_with("MENU"));
}

TEST_CASE("Letters are closed bodies, each for itself, and keep within their bounds") {
  const std::string all = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789&!?'-.,";
  for (const char letter : all) {
    INFO(letter);
    const std::string words(1, letter);
    const Mesh tube = text_mesh_of({{"words", words}, {"height", 0.2}, {"radius", 0.008}});
    const Mesh flat = text_mesh_of({{"words", words}, {"height", 0.2}, {"depth", 0.02}});
    for (const Mesh& mesh : {tube, flat}) {
      CHECK(is_closed(mesh));
      CHECK(volume(mesh) > 0.0);
    }
  }
  CHECK(stretches(text_mesh_of({{"words", "Hello"}, {"height", 0.2}, {"radius", 0.008}})) == 5);
  CHECK(stretches(text_mesh_of({{"words", "OPEN LATE"}, {"height", 0.2}, {"depth", 0.02}})) == 8);
  const Mesh fitted = text_mesh_of(
      {{"words", "A LONG WORD\nAND MORE"}, {"height", 0.5}, {"fit", {0.6, 0.1}}, {"width", 0.004}});
  const Bounds3 box = bounds(fitted);
  CHECK(box.size().x() <= 0.6 + 0.006);
  CHECK(box.size().z() <= 0.1 + 0.006);
  CHECK(std::abs(box.center().z()) < 0.01);
}
