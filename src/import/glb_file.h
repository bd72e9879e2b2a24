#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/json_reader.h"
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

/// A text in the extras of a node, mesh or material; empty if there is none. In the files of others extras
/// may be anything.
std::string text_in_extras(const JsonReader& owner, std::string_view key);

}  // namespace roomgen::detail
