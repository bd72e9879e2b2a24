// The files of layers, read back by what knows nothing of how they were written.
#include <png.h>

#include <Eigen/Geometry>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>

#include "catch.h"
#include "support/json_of.h"
#include "drawing.h"
#include "roomgen/assets/catalogue.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/render/pictures.h"
#include "support/furnished_room.h"
#include "support/temporary_folder.h"
#include "view/category_colors.h"

using namespace roomgen;

namespace {

Eigen::Matrix4d matrix_of(const Json& rows) {
  Eigen::Matrix4d m;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) m(row, column) = rows[row][column].get<double>();
  return m;
}

// Where the file's camera sees a point: column, row, depth.
Vec3 projected(const Json& camera, const Vec3& point) {
  const bool pinhole = camera["model"] == "pinhole";
  const auto& scale = camera[pinhole ? "focal_length_px" : "pixels_per_metre"];
  const Vec3 p = (matrix_of(camera["camera_from_world"]) * point.homogeneous()).head<3>();
  const double by = pinhole ? p.z() : 1.0;
  return {scale[0].get<double>() * p.x() / by + camera["principal_point_px"][0].get<double>(),
          scale[1].get<double>() * p.y() / by + camera["principal_point_px"][1].get<double>(), p.z()};
}

// Empty unless the file has one channel of 16 bits.
std::vector<std::uint16_t> gray_pixels(const std::filesystem::path& path) {
  std::FILE* file = std::fopen(path.c_str(), "rb");
  REQUIRE(file);
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file);
  png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  std::vector<std::uint16_t> pixels;
  if (png_get_bit_depth(png, info) == 16 && png_get_channels(png, info) == 1)
    for (png_uint_32 y = 0; y < png_get_image_height(png, info); ++y)
      for (png_uint_32 x = 0; x < png_get_image_width(png, info); ++x) {
        const auto* bytes = png_get_rows(png, info)[y] + 2 * x;
        pixels.push_back(static_cast<std::uint16_t>(bytes[0] << 8 | bytes[1]));
      }
  png_destroy_read_struct(&png, &info, nullptr);
  std::fclose(file);
  return pixels;
}

std::size_t distinct_colors_in(const Image& image) {
  std::set<std::array<std::uint8_t, 3>> colors;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4)
    colors.insert({image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]});
  return colors.size();
}

}  // namespace

TEST_CASE("the camera of a file projects points where the library's does, and names what is there") {
  auto renderer = make_renderer();
  const Scene scene = test::furnished_room();
  const TemporaryFolder folder;
  for (const auto kind : {View::Kind::top, View::Kind::isometric, View::Kind::eye}) {
    View view;
    view.kind = kind;
    view.pixels = 200;
    Shot shot{*make_camera(scene, view), kind, true, true};
    const auto layers = renderer->layers(scene, {}, shot);
    REQUIRE(layers);
    auto output = OutputFolder::open(folder / "shots");
    REQUIRE(output);
    REQUIRE(write_layers(*output, "shot", *layers));
    REQUIRE(output->commit());
    const Json json = json_of(folder / "shots" / "shot.json");
    for (const Vec3& point : {Vec3(1, 1, 0), Vec3(3.1, 2.2, 1.4), Vec3(2.6, 0.6, 0.02)}) {
      const Vec3 found = projected(json["camera"], point);
      if (found.z() < 0.1) continue;
      CHECK((found.head<2>() - shot.camera.pixel(point)).norm() < 1e-3);
      CHECK(std::abs(found.z() - shot.camera.distance(point)) < 1e-6);
    }
    CHECK((matrix_of(json["camera"]["world_from_camera"]) * matrix_of(json["camera"]["camera_from_world"]) -
           Eigen::Matrix4d::Identity()).norm() < 1e-6);
    std::size_t pixels = 0;
    for (const auto& thing : json["things"]) {
      pixels += thing["pixels"].get<std::size_t>();
      CHECK(thing["pixels"] <= thing["pixels_alone"]);
    }
    CHECK(pixels <= layers->objects.size());
    for (const auto& [layer, file] : json["files"].items()) {
      const auto bytes = read_file(folder / "shots" / file.get<std::string>());
      REQUIRE(bytes);
      const auto image = assets::decode_image(*bytes);
      REQUIRE(image);
      CHECK(image->width == shot.camera.width);
      CHECK(image->height == shot.camera.height);
      if (layer == "segments") CHECK(distinct_colors_in(*image) <= json["categories"].size() + 1);
    }
  }
}

TEST_CASE("numbers of 16 bits are in the file as they are, the higher byte first") {
  auto renderer = make_renderer();
  Scene scene;
  scene.room = test::plain_room();
  Shot shot;
  shot.color = false;
  shot.kind = View::Kind::top;
  shot.camera = *make_camera(scene, {});
  const auto layers = renderer->layers(scene, {}, shot);
  REQUIRE(layers);
  const TemporaryFolder folder;
  auto output = OutputFolder::open(folder / "shots");
  REQUIRE(output);
  REQUIRE(write_layers(*output, "top", *layers));
  REQUIRE(output->commit());
  CHECK((gray_pixels(folder / "shots" / "top.instances.png") == layers->objects));
  CHECK((gray_pixels(folder / "shots" / "top.categories.png") == layers->categories));
  const auto depths = gray_pixels(folder / "shots" / "top.depth.png");
  REQUIRE(depths.size() == layers->depths.size());
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const float metres = layers->depths[i];
    REQUIRE(depths[i] == (std::isinf(metres) ? 0 : std::lround(1000.0 * metres)));
  }
}

TEST_CASE("categories have colours of their own, however many there are") {
  std::set<std::string> names;
  for (int k = 0; k < 100; ++k) {
    names.insert("category " + std::to_string(k));
    std::set<Rgb> colors;
    for (const auto& [name, color] : category_colors(names)) colors.insert(color);
    CHECK(colors.size() == names.size());
  }
  CHECK(category_colors({"floor", "sofa"}).at("floor") == category_colors({"bed", "floor"}).at("floor"));
}

TEST_CASE("the picture of segments shows each thing in the colour of its category, within its size") {
  auto renderer = make_renderer();
  const Scene scene = test::furnished_room();
  for (const int pixels : {300, 1024}) {
    const auto image = segmentation_picture(*renderer, scene, {}, pixels);
    REQUIRE(image);
    CHECK(std::max(image->width, image->height) <= pixels + 1);
    std::map<Rgb, int> count;
    for (std::size_t i = 0; i < image->pixels.size(); i += 4)
      ++count[{image->pixels[i], image->pixels[i + 1], image->pixels[i + 2]}];
    const auto colors = category_colors(
        {"bed", "desk", "chair", "lamp", "rug", "floor", "wall", "ceiling", "door", "window"});
    for (const auto& [category, color] : colors)
      if (category != "ceiling") CHECK(count[color] > 5);
    CHECK(count[colors.at("bed")] > 2 * count[colors.at("desk")]);
  }
  CHECK_FALSE(segmentation_picture(*renderer, scene, {}, 10));
  CHECK_FALSE(segmentation_picture(*renderer, Scene{}, {}, 500));
}

TEST_CASE("cameras of a file are read, and what is wrong is found") {
  const auto read = [](const std::string& text) {
    return cameras_from_json(*parse_json(text, "cameras.json"), "cameras.json");
  };
  const auto good = read(R"({"cameras": [{"name": "a", "eye": [1, 1, 1.5], "target": [3, 2, 0], "angle_deg": 90,
                                           "width": 320, "height": 200},
                                          {"name": "b", "eye": [1, 1, 1], "target": [2, 1, 1]}]})");
  REQUIRE(good);
  REQUIRE(good->size() == 2);
  CHECK(std::abs((*good)[0].camera.pixels_per_metre - 160.0) < 1e-9);
  CHECK(((*good)[0].camera.pixel({3, 2, 0}) - Vec2(160, 100)).norm() < 1e-9);
  const std::pair<const char*, const char*> wrong[] = {
      {R"({"cameras": []})", "/cameras"},
      {R"({"cameras": [{"name": "../a", "eye": [1,1,1], "target": [2,1,1]}]})", "/cameras/0/name"},
      {R"({"cameras": [{"name": "a", "eye": [1,1,1], "target": [1,1,1]}]})", "two points"},
      {R"({"cameras": [{"name": "a", "eye": [1,1], "target": [2,1,1]}]})", "/cameras/0/eye"},
      {R"({"cameras": [{"name": "a", "eye": [1,1,1], "target": [2,1,1], "fov": 3}]})", "fov"},
      {R"({"cameras": [{"name": "a", "eye": [1,1,1], "target": [2,1,1]},
                       {"name": "a", "eye": [1,1,1], "target": [2,1,1]}]})",
       "/cameras/1/name"}};
  for (const auto& [text, part] : wrong) {
    const auto cameras = read(text);
    INFO(text);
    REQUIRE_FALSE(cameras);
    INFO(cameras.error().message);
    CHECK(cameras.error().message.find(part) != std::string::npos);
  }
}
