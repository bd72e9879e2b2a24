#pragma once

#include "gl.h"
// After the header that asks for prototypes.
#include <GL/osmesa.h>

#include "roomgen/base/result.h"

namespace roomgen::detail {

/// The functions of OSMesa that are used. It brings a compiler with it (40 MB of LLVM): loaded with the
/// first picture and not with the program.
struct OsMesa {
#define ROOMGEN_OSMESA_FUNCTIONS(X) \
  X(CreateContextAttribs) X(DestroyContext) X(MakeCurrent) X(GetProcAddress)
#define ROOMGEN_DECLARE(name) decltype(&::OSMesa##name) name = nullptr;
  ROOMGEN_OSMESA_FUNCTIONS(ROOMGEN_DECLARE)
#undef ROOMGEN_DECLARE
};

/// Loads it once a program; Error::Kind::unavailable where there is none.
const Result<OsMesa>& osmesa();

}  // namespace roomgen::detail
