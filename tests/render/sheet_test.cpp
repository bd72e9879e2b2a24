#include <algorithm>

#include "catch.h"
#include "drawing.h"
#include "view/sheet_layout.h"

using namespace roomgen;

namespace {

ContactSheet::Thing box_of(const Vec3& size, const std::string& label) {
  Object object;
  object.category = "chair";
  object.size = size;
  return {object, label, "a box"};
}

ContactSheet two_rows() {
  ContactSheet sheet;
  sheet.rows = {{"1. cubes", {box_of({1, 1, 1}, "1a"), box_of({0.5, 0.5, 0.5}, "1b")}},
                {"2. a board", {box_of({0.02, 0.02, 0.4}, "2a")}}};
  return sheet;
}

// Rows of pixels of a part of the picture that differ from paper.
int drawn_height(const Image& image, int x0, int x1, int y0, int y1) {
  int rows = 0;
  for (int y = y0; y < y1; ++y) {
    bool is_drawn = false;
    for (int x = x0; x < x1; ++x) is_drawn = is_drawn || image.at(x, y)[2] < 225;
    rows += is_drawn;
  }
  return rows;
}

}  // namespace

TEST_CASE("A contact sheet shows things of a row at one scale, each row as large as it fits") {
  const auto renderer = make_renderer();
  const auto image = renderer->sheet(two_rows(), {});
  REQUIRE(image);
  CHECK(image->width == 1024);
  const int half = image->height / 2, top = 24, foot = 18, label = 60;
  const int large = drawn_height(*image, label, 512, top, half - foot);
  const int small = drawn_height(*image, 512 + label, 1024, top, half - foot);
  CHECK(large > (half - top - foot) * 8 / 10);
  CHECK(std::abs(large - 2 * small) <= 4);
  CHECK(drawn_height(*image, label, 512, half + top, image->height - foot) >
        (half - top - foot) * 8 / 10);
  CHECK(drawn_height(*image, 4, 40, 20, 48) > 8);  // a label
  const auto again = renderer->sheet(two_rows(), {});
  REQUIRE(again);
  CHECK(std::equal(image->pixels.begin(), image->pixels.end(), again->pixels.begin()));
}

TEST_CASE("Everything of a contact sheet lies within its cell") {
  ContactSheet sheet;
  for (int row = 0; row < 10; ++row)
    sheet.rows.push_back({"row",
                          {box_of({2.0, 0.1, 0.3}, "a"), box_of({0.1, 2.0, 0.1}, "b"),
                           box_of({0.3, 0.3, 2.2}, "c")}});
  const auto layout = lay_out(sheet);
  REQUIRE(layout);
  REQUIRE(layout->objects.size() == 30);
  const double width = layout->camera.width / 3.0, height = layout->camera.height / 10.0;
  for (std::size_t i = 0; i < layout->objects.size(); ++i)
    for (const auto& corner : box_corners(layout->objects[i])) {
      const Vec2 pixel = layout->camera.pixel(corner);
      CHECK(static_cast<std::size_t>(pixel.x() / width) == i % 3);
      CHECK(static_cast<std::size_t>(pixel.y() / height) == i / 3);
      CHECK(layout->camera.depth(corner) < layout->camera.near);
      CHECK(layout->camera.depth(corner) > layout->camera.far);
    }
  CHECK_FALSE(lay_out({}));
}
