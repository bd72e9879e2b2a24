#pragma once

#include <string>

#include "command.h"
#include "models.h"
#include "roomgen/solve/solve.h"

namespace roomgen::cli {

/// What `solve --samples` is told.
struct SampleWish {
  std::string file;    ///< problem.json, scene.json, plan.json or program.json
  std::string output;  ///< empty: stdout
  SampleOptions options;
  ModelOptions models;
  bool strict = false;
};

/// Writes one layout a line, and says how many were found. The room that was made of a plan or a program goes beside
/// them: layouts.jsonl has layouts.scene.json.
Result<int> write_samples(const Context& context, const SampleWish& wish);

/// Examines such lines. `varied` is the file that they were drawn from.
Result<int> check_samples(const Context& context, const std::string& file, const std::string& varied,
                          const ModelOptions& models);

}  // namespace roomgen::cli
