#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"

namespace roomgen::detail {

/// A .glb file: its description, and what that refers to.
struct GlbFile {
  Json json;
  std::string bytes;
  std::size_t binary_begin = 0, binary_length = 0;  ///< in `bytes`; no length: there is none

  std::string_view binary() const { return std::string_view(bytes).substr(binary_begin, binary_length); }
};
Result<GlbFile> read_glb_file(const std::filesystem::path& path);

}  // namespace roomgen::detail
