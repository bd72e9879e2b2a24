#include <png.h>

#include <csetjmp>
#include <cstring>

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

Result<Image> decode_png(std::string_view bytes) {
  png_image header;
  std::memset(&header, 0, sizeof header);
  header.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()))
    return png_error_of(header.message);
  if (static_cast<std::size_t>(header.width) * header.height > max_image_pixels) {
    png_image_free(&header);
    return Error{Error::Kind::limit, "PNG: the picture is too large"};
  }
  header.format = PNG_FORMAT_RGBA;
  Image image(static_cast<int>(header.width), static_cast<int>(header.height));
  if (!png_image_finish_read(&header, nullptr, image.pixels.data(), 0, nullptr))
    return png_error_of(header.message);
  return image;
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

Result<Image> read_png(const std::filesystem::path& path) {
  const auto bytes = read_file(path, std::size_t{256} << 20);
  if (!bytes) return bytes.error();
  auto image = decode_png(*bytes);
  if (!image) return with_context(image.error(), path.string());
  return image;
}

}  // namespace roomgen
