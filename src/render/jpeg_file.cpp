#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <jpeglib.h>

#include "roomgen/render/pictures.h"

namespace roomgen {

namespace {

struct ErrorHandler {
  jpeg_error_mgr manager;
  std::jmp_buf jump;
};

[[noreturn]] void on_error(j_common_ptr info) {
  std::longjmp(reinterpret_cast<ErrorHandler*>(info->err)->jump, 1);
}

// `row` holds one line of RGB; `buffer` is allocated by libjpeg and freed by the caller.
bool compress(const Image& image, int quality, std::vector<JSAMPLE>& row, unsigned char*& buffer,
              unsigned long& size) {
  jpeg_compress_struct jpeg;
  ErrorHandler handler;
  jpeg.err = jpeg_std_error(&handler.manager);
  handler.manager.error_exit = on_error;
  if (setjmp(handler.jump)) {
    jpeg_destroy_compress(&jpeg);
    return false;
  }
  jpeg_create_compress(&jpeg);
  jpeg_mem_dest(&jpeg, &buffer, &size);
  jpeg.image_width = static_cast<JDIMENSION>(image.width);
  jpeg.image_height = static_cast<JDIMENSION>(image.height);
  jpeg.input_components = 3;
  jpeg.in_color_space = JCS_RGB;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, quality, TRUE);
  jpeg_start_compress(&jpeg, TRUE);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c) row[static_cast<std::size_t>(3 * x + c)] = image.at(x, y)[c];
    JSAMPROW line = row.data();
    jpeg_write_scanlines(&jpeg, &line, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  return true;
}

}  // namespace

Result<std::string> encode_jpeg(const Image& image, int quality) {
  if (image.width < 1 || image.height < 1 || image.width > 65500 || image.height > 65500)
    return Error{Error::Kind::invalid_input, "JPEG: the picture must be 1 to 65500 pixels a side"};
  std::vector<JSAMPLE> row(static_cast<std::size_t>(image.width) * 3);
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  const bool ok = compress(image, quality, row, buffer, size);
  std::string bytes;
  if (ok) bytes.assign(reinterpret_cast<const char*>(buffer), size);
  std::free(buffer);
  if (!ok) return Error{Error::Kind::io, "JPEG: the picture cannot be encoded"};
  return bytes;
}

}  // namespace roomgen
