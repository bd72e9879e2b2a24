#pragma once

#include <string>
#include <vector>

#include "roomgen/evaluate/report.h"

namespace roomgen::cli {

/// What `check` says of a scene, for scripts.
Json check_json(const Scene& scene, const SceneReport& report);

/// "scene of 14 objects, 0 unplaced; 28 of 28 constraints held; 0 faults"
std::string check_headline(const Scene& scene, const SceneReport& report);
/// Every fault, and every constraint that does not hold.
std::vector<std::string> check_lines(const SceneReport& report);
/// What the prompt and the edits asked for and is not so: "two lamps: one is there".
std::vector<std::string> unmet(const Scene& scene);

}  // namespace roomgen::cli
