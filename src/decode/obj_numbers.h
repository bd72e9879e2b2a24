#pragma once

#include <string>
#include <string_view>

namespace roomgen::decode {

/// A Wavefront file with ".4" written "0.4" in its lines of vertices: assimp (5.2) does not count the first as a number and
/// drops the vertex, so that every later one is another.
std::string with_leading_zeros(std::string_view obj);

}  // namespace roomgen::decode
