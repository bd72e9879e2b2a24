#pragma once

#include <opencv2/imgproc/imgproc_c.h>

#include "roomgen/base/result.h"

namespace roomgen::detail {

/// The functions of OpenCV that draw. Loaded with the first picture that is drawn upon and not with the
/// program (it brings TBB and LAPACK with it), and so by its C interface.
struct OpenCv {
#define ROOMGEN_OPENCV_FUNCTIONS(X) \
  X(PolyLine) X(FillConvexPoly) X(InitFont) X(GetTextSize) X(PutText)
#define ROOMGEN_DECLARE(name) decltype(&::cv##name) name = nullptr;
  ROOMGEN_OPENCV_FUNCTIONS(ROOMGEN_DECLARE)
#undef ROOMGEN_DECLARE
};

/// Loads it once a program; Error::Kind::unavailable where there is none.
const Result<OpenCv>& opencv();

}  // namespace roomgen::detail
