#pragma once

#include <string>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/create/create.h"
#include "roomgen/shape/program.h"

namespace roomgen::create {

/// Where a thing is fixed: things on walls and ceilings need no ground; they count as grounded, and
/// as stable when they are one piece.
enum class Footing { ground, wall, ceiling };

struct ValidateOptions {
  Footing footing = Footing::ground;
  double contact = 0.002;  ///< bodies this near touch, metres
  double sink = 0.002;     ///< how deep a part that was moved sinks into what it is joined to
  int rounds = 4;
  /// Labels tell nothing of what shall touch or stand, and the whole goes on its lowest point.
  bool as_drawn = false;
};

/// Measures only.
Result<Soundness> inspect(const shape::Program& program, const ValidateOptions& options = {});

struct Validation {
  shape::Program program;            ///< repaired
  std::vector<std::string> repairs;  ///< what was changed, for people
  Soundness before, after;
};

/// The validator of the paper (primitives, section 3.5), on real meshes instead of boxes:
/// connection map (the program's, else by labels and nearness), ground contact, supports under what
/// they carry, every connection closed by moving or stretching the part of lowest priority, then
/// stability. Parts that are copies of each other stay so.
Result<Validation> validate(const shape::Program& program, const ValidateOptions& options = {});

}  // namespace roomgen::create
