#include <png.h>

#include <bit>
#include <csetjmp>
#include <functional>

#include "gray_png.h"
#include "roomgen/base/file.h"
#include "roomgen/render/pictures.h"

namespace roomgen {

namespace {

Error png_error_of(const char* what) {
  return {Error::Kind::invalid_input, std::string("PNG: ") + what};
}

// libpng reports errors by a long jump: nothing between setjmp and the end may need a destructor
// that was not constructed before.
void append_bytes(png_structp png, png_bytep data, std::size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

// Pixels as libpng takes them.
struct Rows {
  int width, height, bits, color_type;
  bool has_filler;  ///< a byte of each pixel is left out
  std::function<const std::uint8_t*(int y)> row;
};

bool write_rows(png_structp png, png_infop info, const Rows& rows, int effort, std::string& out) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_write_fn(png, &out, append_bytes, nullptr);
  png_set_compression_level(png, effort);
  png_set_filter(png, 0, PNG_FILTER_SUB | PNG_FILTER_UP);
  png_set_IHDR(png, info, static_cast<png_uint_32>(rows.width), static_cast<png_uint_32>(rows.height), rows.bits,
               rows.color_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  if (rows.has_filler) png_set_filler(png, 0, PNG_FILLER_AFTER);
  // Files have the higher byte first.
  if (rows.bits == 16 && std::endian::native == std::endian::little) png_set_swap(png);
  for (int y = 0; y < rows.height; ++y) png_write_row(png, rows.row(y));
  png_write_end(png, info);
  return true;
}

Result<std::string> encode(const Rows& rows, int effort) {
  if (rows.width < 1 || rows.height < 1) return png_error_of("the picture has no pixels");
  std::string out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  const bool ok = info && write_rows(png, info, rows, effort, out);
  png_destroy_write_struct(&png, &info);
  if (!ok) return png_error_of("the picture cannot be encoded");
  return out;
}

}  // namespace

Result<std::string> encode_png(const Image& image, int effort) {
  const bool opaque = is_opaque(image);
  return encode({image.width, image.height, 8, opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, opaque,
                 [&](int y) { return image.at(0, y); }},
                effort);
}

Result<std::string> detail::encode_gray_png(const std::vector<std::uint16_t>& values, int width, int height) {
  constexpr int effort = 3;
  return encode({width, height, 16, PNG_COLOR_TYPE_GRAY, false,
                 [&](int y) {
                   return reinterpret_cast<const std::uint8_t*>(&values[static_cast<std::size_t>(y) *
                                                                        static_cast<std::size_t>(width)]);
                 }},
                effort);
}

Status write_png(const std::filesystem::path& path, const Image& image) {
  const auto bytes = encode_png(image);
  if (!bytes) return bytes.error();
  return write_file(path, *bytes);
}

Status write_png(const OutputFolder& folder, const std::filesystem::path& name,
                 const Image& image) {
  return folder.write_with(name, [&](const std::filesystem::path& now) { return write_png(now, image); });
}

}  // namespace roomgen
