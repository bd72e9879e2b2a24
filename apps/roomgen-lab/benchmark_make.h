#pragma once

#include <string>
#include <vector>

#include "command.h"
#include "libraries.h"
#include "roomgen/lab/draw_frames.h"

namespace roomgen::cli {

/// What `roomgen benchmark make` is told (docs/questions.md).
struct BenchmarkMakeOptions {
  std::string output, levels;
  std::vector<std::string> rooms, tasks;
  std::vector<std::string> compositional = {"low", "medium", "high"}, relational = {"medium"}, observational = {"low"};
  int scenes = 1;    ///< of each sort of room
  int per_form = 4;
  int jobs = 2;
  std::uint64_t seed = 0;
  lab::FrameOptions frames;
  LibraryOptions libraries;
};

/// Furnishes the base rooms, and makes of each one scene, tour, frames and questions for every cell of the grid. What
/// is done already is kept.
Result<int> make_benchmark(const Context& context, const BenchmarkMakeOptions& options);

}  // namespace roomgen::cli
