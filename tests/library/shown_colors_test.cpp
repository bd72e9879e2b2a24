#include "library/shown_colors.h"

#include "base/random.h"
#include "catch.h"

using namespace roomgen;

namespace {

Material paint(float r, float g, float b, float alpha = 1.0f) {
  Material material;
  material.base_color = {linear_from_srgb(r), linear_from_srgb(g), linear_from_srgb(b), alpha};
  return material;
}

void add_box(Model& model, const Vec3& low, const Vec3& high, const Material& material) {
  model.parts.push_back({make_box(low, high), static_cast<int>(model.materials.size())});
  model.materials.push_back(material);
}

double share(const std::vector<ShownColor>& colors, const std::string& name) {
  for (const auto& color : colors)
    if (color.name == name) return color.share;
  return 0.0;
}

const Material red = paint(220, 20, 20), white = paint(250, 250, 250), blue = paint(20, 40, 220);

}  // namespace

TEST_CASE("What is inside is not seen") {
  Model cupboard;
  add_box(cupboard, {0, 0, 0}, {1, 1, 1}, white);
  for (int shelf = 1; shelf < 9; ++shelf) add_box(cupboard, {0.1, 0.1, 0.1 * shelf}, {0.9, 0.9, 0.1 * shelf + 0.05}, red);
  const auto colors = shown_colors(cupboard);
  REQUIRE(colors.size() == 1);
  CHECK(colors.front().name == "white");
  CHECK(colors.front().share == Approx(1.0));
  CHECK(lightness(colors.front().mean) > 0.9);
}

TEST_CASE("Through glass one sees what is behind, and glass alone is seen") {
  Model vitrine;
  add_box(vitrine, {0, 0, 0}, {1, 1, 1}, paint(240, 240, 240, 0.3f));
  CHECK(shown_colors(vitrine).front().name == "white");
  add_box(vitrine, {0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}, red);
  CHECK(shown_colors(vitrine).front().name == "red");
}

TEST_CASE("Shares are those of the sides that are looked at") {
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const Vec3 size(random.uniform(0.3, 2), random.uniform(0.3, 2), random.uniform(0.3, 2));
    const double board = 0.25 * size.z();
    Model table;  // a red board on a blue block, as wide
    add_box(table, {0, 0, 0}, {size.x(), size.y(), size.z() - board}, blue);
    add_box(table, {0, 0, size.z() - board}, size, red);
    const double around = size.x() + 2 * size.y(), top = size.x() * size.y();
    const double expected = (top + around * board) / (top + around * size.z());
    CHECK(share(shown_colors(table), "red") == Approx(expected).margin(0.06));
  }
}

TEST_CASE("Stripes are two colours, and fine grain is one") {
  const auto striped = [](int stripe) {
    auto image = std::make_shared<Image>(96, 96);
    for (int y = 0; y < 96; ++y)
      for (int x = 0; x < 96; ++x) {
        const bool odd = (x / stripe) % 2 == 1;
        const std::uint8_t pixel[4] = {static_cast<std::uint8_t>(odd ? 255 : 20), static_cast<std::uint8_t>(odd ? 255 : 40),
                                       static_cast<std::uint8_t>(odd ? 255 : 220), 255};
        std::copy(pixel, pixel + 4, image->at(x, y));
      }
    Model rug;
    Material material = paint(255, 255, 255);
    material.texture = image;
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
    mesh.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    rug.parts = {{mesh, 0}};
    rug.materials = {material};
    return shown_colors(rug);
  };
  const auto coarse = striped(16);
  CHECK(share(coarse, "blue") == Approx(0.5).margin(0.05));
  CHECK(share(coarse, "white") == Approx(0.5).margin(0.05));
  CHECK(striped(1).size() == 1);
}

TEST_CASE("Nothing shows nothing") {
  CHECK(shown_colors(Model()).empty());
  CHECK(main_colors(Model()).empty());
}

TEST_CASE("Colours have the names that people give them") {
  CHECK(color_name(255, 255, 255) == "white");
  CHECK(color_name(20, 20, 22) == "black");
  CHECK(color_name(128, 128, 128) == "grey");
  CHECK(color_name(110, 70, 40) == "brown");
  CHECK(color_name(70, 30, 28) == "brown");
  CHECK(color_name(140, 20, 20) == "red");
  CHECK(color_name(30, 140, 60) == "green");
  CHECK(color_name(245, 160, 190) == "pink");
}
