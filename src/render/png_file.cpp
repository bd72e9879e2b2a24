#include <png.h>

#include <csetjmp>

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

bool write_rows(png_structp png, png_infop info, const Image& image, bool opaque, int effort,
                std::string& out) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_write_fn(png, &out, append_bytes, nullptr);
  png_set_compression_level(png, effort);
  png_set_filter(png, 0, PNG_FILTER_SUB | PNG_FILTER_UP);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8,
               opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  if (opaque) png_set_filler(png, 0, PNG_FILLER_AFTER);
  for (int y = 0; y < image.height; ++y) png_write_row(png, image.at(0, y));
  png_write_end(png, info);
  return true;
}

}  // namespace

Result<std::string> encode_png(const Image& image, int effort) {
  if (image.width < 1 || image.height < 1) return png_error_of("the picture has no pixels");
  std::string out;
  const bool opaque = is_opaque(image);
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  const bool ok = info && write_rows(png, info, image, opaque, effort, out);
  png_destroy_write_struct(&png, &info);
  if (!ok) return png_error_of("the picture cannot be encoded");
  return out;
}

Status write_png(const std::filesystem::path& path, const Image& image) {
  const auto bytes = encode_png(image);
  if (!bytes) return bytes.error();
  return write_file(path, *bytes);
}

Status write_png(const OutputFolder& folder, const std::filesystem::path& name,
                 const Image& image) {
  const auto place = folder.place_for(name);
  return place ? write_png(*place, image) : Status(place.error());
}

}  // namespace roomgen
