#include "opencv.h"

#include "base/shared_library.h"

namespace roomgen::detail {

namespace {

Result<OpenCv> load_opencv() {
  const auto library = SharedLibrary::open(ROOMGEN_OPENCV_IMGPROC);
  if (!library) return library.error();
  OpenCv cv;
#define ROOMGEN_FIND(name) \
  if (auto found = library->find("cv" #name, cv.name); !found) return found.error();
  ROOMGEN_OPENCV_FUNCTIONS(ROOMGEN_FIND)
#undef ROOMGEN_FIND
  return cv;
}

}  // namespace

const Result<OpenCv>& opencv() {
  static const Result<OpenCv> cv = load_opencv();
  return cv;
}

}  // namespace roomgen::detail
