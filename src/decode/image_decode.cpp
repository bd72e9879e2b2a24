#include "image_decode.h"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstdint>
#include <cstdio>  // jpeglib.h needs FILE
#include <cstring>
#include <new>
#include <vector>

#include <jerror.h>
#include <jpeglib.h>

namespace roomgen::decode {

namespace {

constexpr int max_source_side = 16384;
constexpr std::size_t max_source_pixels = 96u << 20;

Error broken(const std::string& what) {
  return {Error::Kind::invalid_input, "picture: " + what};
}

bool too_large(std::size_t width, std::size_t height) {
  return width == 0 || height == 0 || width > max_source_side || height > max_source_side ||
         width * height > max_source_pixels;
}

Result<Image> decode_png(std::string_view bytes) {
  png_image png;
  std::memset(&png, 0, sizeof png);
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()))
    return broken(png.message);
  if (too_large(png.width, png.height)) {
    png_image_free(&png);
    return broken("too large");
  }
  png.format = PNG_FORMAT_RGBA;
  Image image(static_cast<int>(png.width), static_cast<int>(png.height));
  if (!png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr))
    return broken(png.message);
  return image;
}

struct JpegError {
  jpeg_error_mgr base;
  std::jmp_buf on_error;
  char message[JMSG_LENGTH_MAX];
};

[[noreturn]] void leave(j_common_ptr info) {
  auto* error = reinterpret_cast<JpegError*>(info->err);
  info->err->format_message(info, error->message);
  std::longjmp(error->on_error, 1);
}

void ignore_message(j_common_ptr) {}

// The largest power of two, up to 8, by which the decoder itself may shrink.
unsigned jpeg_shrink(unsigned width, unsigned height, int max_side) {
  unsigned shrink = 1;
  while (shrink < 8 && std::max(width, height) / (2 * shrink) >= static_cast<unsigned>(max_side))
    shrink *= 2;
  return shrink;
}

void rgba_from_rgb(const std::uint8_t* rgb, std::uint8_t* rgba, std::size_t pixels) {
  for (std::size_t i = 0; i < pixels; ++i) {
    std::memcpy(rgba + 4 * i, rgb + 3 * i, 3);
    rgba[4 * i + 3] = 255;
  }
}

// libjpeg reports errors by longjmp, so that everything with a destructor lives in the caller.
bool read_jpeg(std::string_view bytes, int max_side, jpeg_decompress_struct& info, JpegError& error,
               Image& image, std::vector<std::uint8_t>& row) {
  if (setjmp(error.on_error)) return false;
  jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&info, TRUE);
  if (too_large(info.image_width, info.image_height)) {
    std::strcpy(error.message, "too large");
    return false;
  }
  info.out_color_space = JCS_RGB;
  info.scale_num = 1;
  info.scale_denom = jpeg_shrink(info.image_width, info.image_height, max_side);
  jpeg_start_decompress(&info);
  image = Image(static_cast<int>(info.output_width), static_cast<int>(info.output_height));
  row.resize(3 * static_cast<std::size_t>(info.output_width));
  while (info.output_scanline < info.output_height) {
    std::uint8_t* target = image.at(0, static_cast<int>(info.output_scanline));
    JSAMPROW rows[1] = {row.data()};
    if (jpeg_read_scanlines(&info, rows, 1) == 1)
      rgba_from_rgb(row.data(), target, info.output_width);
  }
  jpeg_finish_decompress(&info);
  return true;
}

Result<Image> decode_jpeg(std::string_view bytes, int max_side) {
  jpeg_decompress_struct info;
  JpegError error;
  std::memset(&error, 0, sizeof error);
  info.err = jpeg_std_error(&error.base);
  error.base.error_exit = leave;
  error.base.output_message = ignore_message;
  jpeg_create_decompress(&info);
  Image image;
  std::vector<std::uint8_t> row;
  const bool good = read_jpeg(bytes, max_side, info, error, image, row);
  jpeg_destroy_decompress(&info);
  if (!good && error.base.msg_code == JERR_OUT_OF_MEMORY) throw std::bad_alloc();
  if (!good) return broken(error.message);
  return image;
}

// Each new pixel is the mean of the old ones that it covers.
Image shrunk(const Image& image, int width, int height) {
  Image result(width, height);
  for (int y = 0; y < height; ++y) {
    const int y0 = static_cast<int>(static_cast<std::int64_t>(y) * image.height / height);
    const int y1 = std::max(
        y0 + 1, static_cast<int>(static_cast<std::int64_t>(y + 1) * image.height / height));
    for (int x = 0; x < width; ++x) {
      const int x0 = static_cast<int>(static_cast<std::int64_t>(x) * image.width / width);
      const int x1 = std::max(
          x0 + 1, static_cast<int>(static_cast<std::int64_t>(x + 1) * image.width / width));
      std::uint32_t sum[4] = {0, 0, 0, 0};
      for (int v = y0; v < y1; ++v)
        for (int u = x0; u < x1; ++u)
          for (int c = 0; c < 4; ++c) sum[c] += image.at(u, v)[c];
      const auto count = static_cast<std::uint32_t>((y1 - y0) * (x1 - x0));
      for (int c = 0; c < 4; ++c)
        result.at(x, y)[c] = static_cast<std::uint8_t>((sum[c] + count / 2) / count);
    }
  }
  return result;
}

}  // namespace

Result<Image> decode_image(std::string_view bytes, int max_side) {
  const bool is_png = bytes.starts_with("\x89PNG");
  const bool is_jpeg = bytes.starts_with("\xFF\xD8");
  if (!is_png && !is_jpeg) return broken("neither PNG nor JPEG");
  auto image = is_png ? decode_png(bytes) : decode_jpeg(bytes, max_side);
  if (!image) return image;
  const int longest = std::max(image->width, image->height);
  if (longest <= max_side) return image;
  const auto scaled = [&](int side) {
    return std::max(1, static_cast<int>(static_cast<std::int64_t>(side) * max_side / longest));
  };
  return shrunk(*image, scaled(image->width), scaled(image->height));
}

}  // namespace roomgen::decode
