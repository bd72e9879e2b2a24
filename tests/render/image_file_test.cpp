#include "roomgen/render/pictures.h"

#include <filesystem>

#include "base/random.h"
#include "catch.h"
#include "roomgen/base/file.h"

using namespace roomgen;

namespace {

Image noise(int width, int height, bool opaque) {
  Random random(5);
  Image image(width, height);
  for (auto& value : image.pixels) value = static_cast<std::uint8_t>(random.next());
  for (std::size_t i = 3; opaque && i < image.pixels.size(); i += 4) image.pixels[i] = 255;
  return image;
}

std::filesystem::path temporary(const char* name) {
  return std::filesystem::temp_directory_path() / name;
}

}  // namespace

TEST_CASE("a PNG reads as it was written, with and without alpha") {
  for (const bool opaque : {true, false}) {
    const Image image = noise(37, 21, opaque);
    const auto path = temporary("roomgen-image-test.png");
    REQUIRE(write_png(path, image));
    const auto back = read_png(path);
    REQUIRE(back);
    CHECK(back->width == 37);
    CHECK(back->height == 21);
    CHECK(back->pixels == image.pixels);
    std::filesystem::remove(path);
  }
}

TEST_CASE("pictures without pixels are refused") {
  CHECK_FALSE(encode_png(Image{}));
  CHECK_FALSE(encode_jpeg(Image{}));
}

TEST_CASE("what is no PNG gives an error that names the file") {
  const auto path = temporary("roomgen-broken-test.png");
  auto bytes = *encode_png(noise(64, 64, true));
  for (const auto& broken :
       {std::string("hello"), std::string(), bytes.substr(0, bytes.size() / 2)}) {
    REQUIRE(write_file(path, broken));
    const auto image = read_png(path);
    REQUIRE_FALSE(image);
    CHECK(image.error().message.find("roomgen-broken-test") != std::string::npos);
  }
  std::filesystem::remove(path);
  CHECK_FALSE(read_png(temporary("roomgen-no-such-file.png")));
}

TEST_CASE("textures become JPEG when that saves space and loses no alpha") {
  CHECK(encode_texture(noise(128, 128, true))->mime_type == "image/jpeg");
  CHECK(encode_texture(noise(128, 128, false))->mime_type == "image/png");
  CHECK(encode_texture(noise(16, 16, true))->mime_type == "image/png");
  CHECK(encode_jpeg(noise(128, 128, true))->substr(0, 2) == "\xff\xd8");
}
