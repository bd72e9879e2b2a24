#pragma once

#include "designers.h"
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

struct ProgramExperimentOptions {
  std::string descriptions, output, cache;
  std::uint64_t seed = 1;
  bool force = false;
  DesignerOptions designer;
};

/// InfiniBench's ablation (docs/benchmarks.md): each description is composed with and without moves of clusters, in up to
/// five rounds; fidelity and the share of constraints that hold after one, three and five. Writes results.jsonl, where the
/// same command goes on, report.md and fidelity.svg.
Result<int> run_program_experiment(const Context& context, const ProgramExperimentOptions& options);

}  // namespace roomgen::cli
