#pragma once

#include <string>

#include "command.h"
#include "libraries.h"

namespace roomgen::cli {

struct InsertionsOptions {
  std::string suite, output;
  bool force = false;
  LibraryOptions libraries;
};

/// The incremental scenes of RoomGen (figure 4): furnishes the suite's rooms by rules, then carries out its
/// sentences one by one. Writes a picture of each step and report.md.
Result<int> run_insertions(const Context& context, const InsertionsOptions& options);

}  // namespace roomgen::cli
