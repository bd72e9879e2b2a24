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
  bool is_made = false;  ///< of a plan or a program: the scene stands in no file yet
};

/// Reads what a file holds: a problem, a scene, or a plan or program, whose room is made first, with the meshes of the
/// libraries. `seed`: of a program's room and search; a plan has its own.
Result<Varied> read_varied(const std::string& file, const ModelOptions& models, std::uint64_t seed,
                           const Context& context);

}  // namespace roomgen::cli
