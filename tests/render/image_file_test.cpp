#include "roomgen/render/pictures.h"

#include <filesystem>

#include "base/random.h"
#include "catch.h"
#include "roomgen/assets/catalogue.h"
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

}  // namespace

TEST_CASE("a PNG reads as it was written, with and without alpha") {
  for (const bool opaque : {true, false}) {
    const Image image = noise(37, 21, opaque);
    const auto bytes = encode_png(image);
    REQUIRE(bytes);
    const auto back = assets::decode_image(*bytes);
    REQUIRE(back);
    CHECK(back->width == 37);
    CHECK(back->height == 21);
    CHECK(back->pixels == image.pixels);
  }
}

TEST_CASE("pictures without pixels are refused") {
  CHECK_FALSE(encode_png(Image{}));
  CHECK_FALSE(encode_jpeg(Image{}));
}

TEST_CASE("what is no PNG is refused") {
  const auto bytes = *encode_png(noise(64, 64, true));
  for (const auto& broken :
       {std::string("hello"), std::string(), bytes.substr(0, bytes.size() / 2)})
    CHECK_FALSE(assets::decode_image(broken));
}

TEST_CASE("a PNG file holds what the encoder gives") {
  const auto path = std::filesystem::temp_directory_path() / "roomgen-image-test.png";
  const Image image = noise(37, 21, true);
  REQUIRE(write_png(path, image));
  CHECK(*read_file(path, std::size_t{1} << 20) == *encode_png(image));
  std::filesystem::remove(path);
}

TEST_CASE("textures become JPEG when that saves space and loses no alpha") {
  CHECK(encode_texture(noise(128, 128, true))->mime_type == "image/jpeg");
  CHECK(encode_texture(noise(128, 128, false))->mime_type == "image/png");
  CHECK(encode_texture(noise(16, 16, true))->mime_type == "image/png");
  CHECK(encode_jpeg(noise(128, 128, true))->substr(0, 2) == "\xff\xd8");
}
