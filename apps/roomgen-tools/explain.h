#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "roomgen/evaluate/report.h"

namespace roomgen::cli {

/// Why a room is as it is, as data and for people.
struct Explanation {
  Json data;
  std::vector<std::string> lines;
};

/// What stands where, what was asked for and what became of it: a line for each element of the
/// lists, in order.
Explanation explain_scene(const Scene& scene);

/// One thing: its relations and whether they hold, what was asked of it, and, from its line of trace.jsonl, why
/// it was placed where it is. not_found with the nearest id for one that is not there.
Result<Explanation> explain_object(const Scene& scene, const SceneReport& report, const std::string& id,
                                   const std::optional<Json>& trace_line);

/// The object's line of the trace.jsonl beside a scene, if there is one.
std::optional<Json> traced(const std::filesystem::path& scene_file, const std::string& id);

}  // namespace roomgen::cli
