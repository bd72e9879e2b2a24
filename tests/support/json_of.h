#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"

/// A JSON file that must be there and be whole.
inline roomgen::Json json_of(const std::filesystem::path& path) {
  const auto text = roomgen::read_file(path);
  REQUIRE(text);
  const auto json = roomgen::parse_json(*text, path.string());
  REQUIRE(json);
  return *json;
}
