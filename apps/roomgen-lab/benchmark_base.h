#pragma once

#include <string>

#include "benchmark_levels.h"
#include "benchmark_make.h"
#include "command.h"
#include "roomgen/scene/scene.h"

namespace roomgen::cli {

/// A room that all cells of a set are derived from.
struct BaseRoom {
  std::string name;  ///< "living-room-0"
  Scene scene;
  ModelTable models;
};

/// The room that the set's folder has, or one furnished now: the first of several that allows all levels asked for, else
/// the one that allows most of them.
Result<BaseRoom> base_room(const Context& context, const BenchmarkMakeOptions& options, const BenchmarkLevels& levels,
                           const std::string& room, int number);

}  // namespace roomgen::cli
