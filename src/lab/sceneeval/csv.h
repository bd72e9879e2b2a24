#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"

namespace roomgen::lab {

/// A record of a CSV file (RFC 4180) and the line on which it starts.
struct CsvRecord {
  int line = 1;
  std::vector<std::string> fields;
};

/// Fields may be quoted, with "" for a quote, and hold line breaks; empty lines are left out.
Result<std::vector<CsvRecord>> parse_csv(std::string_view text, const std::string& source);

}  // namespace roomgen::lab
