#include "wish_pictures.h"

#include "roomgen/assets/catalogue.h"
#include "roomgen/base/file.h"

namespace roomgen::cli {

namespace {

constexpr int most_pictures = 4, most_side = 1024;
constexpr std::size_t most_bytes = 30'000'000, most_pixels = 40'000'000;

std::size_t number_at(std::string_view bytes, std::size_t at, std::size_t count) {
  std::size_t number = 0;
  for (std::size_t i = at; i < at + count; ++i)
    number = number << 8 | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u);
  return number;
}

bool is_png(std::string_view bytes) { return bytes.starts_with("\x89PNG\r\n\x1a\n"); }
bool is_jpeg(std::string_view bytes) { return bytes.starts_with("\xff\xd8\xff"); }

// Of a JPEG by its frame header (ITU-T T.81, B.2.2), of a PNG by its first chunk; else 0.
std::size_t pixels_of(std::string_view bytes) {
  if (is_png(bytes)) return number_at(bytes, 16, 4) * number_at(bytes, 20, 4);
  for (std::size_t at = 2; at + 9 < bytes.size(); at += 2 + number_at(bytes, at + 2, 2)) {
    const std::size_t marker = number_at(bytes, at, 2);
    const bool is_other = marker != 0xffc0 && marker % 4 == 0;
    if (marker >= 0xffc0 && marker <= 0xffcf && !is_other)
      return number_at(bytes, at + 5, 2) * number_at(bytes, at + 7, 2);
    if (marker < 0xff00) return 0;
  }
  return 0;
}

Error unusable(const std::string& file, const std::string& what) {
  return {Error::Kind::invalid_input, file + ": " + what};
}

}  // namespace

CLI::Option* add_image_option(CLI::App& command, std::vector<std::string>& files) {
  return command
      .add_option("--image", files,
                  "A photo of a room or a style, or a picture of a floor plan, that the model reads "
                  "with the wish (PNG or JPEG; up to 4)")
      ->allow_extra_args(false)
      ->expected(1, most_pictures);
}

Result<std::vector<std::string>> read_wish_pictures(const std::vector<std::string>& files,
                                                    const DesignerOptions& options) {
  std::vector<std::string> pictures;
  const auto decode = assets::picture_decoder({.libraries = {}, .cache_dir = {}}, most_side);
  for (const auto& file : files) {
    const auto bytes = read_file(file, most_bytes);
    if (!bytes) return with_context(bytes.error(), "--image");
    if (!is_png(*bytes) && !is_jpeg(*bytes))
      return unusable(file, "no PNG and no JPEG; convert it to one of them");
    if (const auto pixels = pixels_of(*bytes); pixels > most_pixels)
      return unusable(file, std::to_string(pixels / 1'000'000) +
                                " megapixels are more than 40; scale it down");
    const auto image = decode(*bytes);
    if (!image) return with_context(image.error(), file);
    auto encoded = encode_for(options, *image);
    if (!encoded) return with_context(encoded.error(), file);
    pictures.push_back(*std::move(encoded));
  }
  return pictures;
}

}  // namespace roomgen::cli
