#pragma once

#include <optional>
#include <string>
#include <vector>

#include "set_ids.h"
#include "set_kinds.h"

namespace roomgen::lab {

/// All that a program's constraints say of the number of members of one set.
struct Demand {
  const ProgramSet* set = nullptr;
  std::vector<std::pair<std::string, const ProgramSet*>> variables = {};
  double low = 0.0, high = 0.0;  ///< of all bounds together
  const ProgramSet* low_set = nullptr;   ///< where the highest lower bound stands
  const ProgramSet* high_set = nullptr;  ///< where the lowest upper bound stands
  double required = 0.0;         ///< so many there must be in the room, for all that the variables stand for
  SetKinds::Mask kinds = {};
  /// Index of the demand for a set that holds all members of this one and allows fewer than this one needs.
  std::optional<std::size_t> contradicted_by = {};
};

/// One for each set that is counted, in the order of the constraints.
std::vector<Demand> demands_of(const ConstraintProgram& program, SetKinds& kinds);

/// The greatest floor that the room may have, m2; nothing if the program does not say.
std::optional<double> greatest_floor(const ProgramRoom& room);
/// The least floor that a thing of these kinds covers at its usual size, m2; 0 if one may stand on, hang from or
/// slide under something.
double least_footprint(const SetKinds::Mask& mask, const SetKinds& kinds);

}  // namespace roomgen::lab
