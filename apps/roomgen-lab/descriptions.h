#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/lab/compose.h"
#include "roomgen/scene/scene.h"

namespace roomgen::cli {

/// A description with what it demands in numbers: a line of bench/programs/descriptions-open.jsonl.
struct Description {
  std::string id, text;
  lab::Complexity measures;
  std::map<std::string, lab::Range> counts;  ///< by noun
};
Result<std::vector<Description>> read_descriptions(const std::string& file);

/// The share of a description's demands that a room meets; a thing counts for the nearest demanded kind that it is of.
/// Nothing if the description demands nothing.
std::optional<double> fidelity(const Description& description, const Scene& scene, double occupancy,
                               const KindTable& kinds);

}  // namespace roomgen::cli
