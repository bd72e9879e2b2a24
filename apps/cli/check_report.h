#pragma once

#include <string>
#include <vector>

#include "roomgen/evaluate/report.h"

namespace roomgen::cli {

/// What `check` says of a scene, for scripts and agents.
Json check_json(const Scene& scene, const SceneReport& report);

/// "scene of 14 objects, 0 unplaced; 28 of 28 constraints held; 9 of 9 clauses met; 0 faults"
std::string check_headline(const Scene& scene, const SceneReport& report);
/// Every fault, every constraint that does not hold, and every clause that is not met.
std::vector<std::string> check_lines(const Scene& scene, const SceneReport& report);

/// What the prompt and the edits ask for, how much of it is so, and what is not: "two lamps: one is
/// there". What an edit withdrew is asked for no more.
struct Clauses {
  std::size_t asked = 0, met = 0;
  std::vector<std::string> unmet;
};
Clauses clauses_of(const Scene& scene);

}  // namespace roomgen::cli
