#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"

namespace roomgen {

/// Gives each line of a file of JSON Lines to `take`, with what an error calls it ("frames.jsonl: line 3"); ends at
/// the first error.
Status read_json_lines(const std::filesystem::path& path, std::size_t most_bytes,
                       const std::function<Status(const Json& line, const std::string& source)>& take);

}  // namespace roomgen
