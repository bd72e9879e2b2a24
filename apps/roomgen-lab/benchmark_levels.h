#pragma once

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/scene/scene.h"
#include "roomgen/lab/tour.h"

namespace roomgen::cli {

/// [least, most]
using LevelRange = std::array<double, 2>;

/// data/benchmark/levels.json, or a file like it.
struct BenchmarkLevels {
  std::map<std::string, std::string> rooms;  ///< prompts of the base rooms
  std::map<std::string, LevelRange> compositional, relational;
  Json observational;
  double sofa_seats = 3;
  int tries = 1;  ///< rooms that are furnished for a base room, until one allows all levels
};
Result<BenchmarkLevels> read_levels(const std::string& file);

/// One value of each factor.
struct BenchmarkCell {
  std::string compositional, relational, observational;

  std::string name() const { return compositional + "-" + relational + "-" + observational; }
};

struct Reduced {
  Scene scene;
  double seats = 0.0, occupancy = 0.0;
  std::string shortfall;  ///< what does not lie in the cell's ranges; empty: it is as defined

  bool as_defined() const { return shortfall.empty(); }
};

/// The base room without so many of its seats and of its other furniture that it is of the cell's levels; what stands
/// on them goes too. What is left stays where it is.
Reduced reduced(const Scene& base, const BenchmarkLevels& levels, const BenchmarkCell& cell);

Result<lab::TourOptions> tour_options(const Scene& scene, const BenchmarkLevels& levels,
                                      const BenchmarkCell& cell);

}  // namespace roomgen::cli
