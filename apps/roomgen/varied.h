#pragma once

#include <optional>
#include <string>

#include "command.h"
#include "models.h"
#include "roomgen/scene/problem.h"

namespace roomgen::cli {

/// A room whose things are put elsewhere: a scene as it is, or a problem that is yet to be solved.
struct Varied {
  std::optional<Problem> problem;
  Scene scene;  ///< of a problem: things without places
  ModelTable models;
  bool is_made = false;  ///< of a plan: the scene stands in no file yet
};

/// Reads what a file holds: a problem, a scene, or a plan, whose room is made first, with the meshes of the libraries.
Result<Varied> read_varied(const std::string& file, const ModelOptions& models,
                           const Context& context);

}  // namespace roomgen::cli
