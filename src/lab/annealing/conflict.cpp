#include <algorithm>

#include "roomgen/lab/optimise.h"

namespace roomgen::lab {

namespace {

constexpr int steps_each = 6000;  // of each trial; what is found is small, not certainly smallest

Result<bool> can_be_had(const ConstraintProgram& program, const Room& room, const Stock& stock, const KindTable& kinds,
                        const OptimiseOptions& options) {
  const auto result = optimise(program, room, stock, kinds, options);
  if (!result) return result.error();
  if (result->scene.incomplete) return Error{Error::Kind::cancelled, "the search was cut"};
  return result->violation <= 1e-9;
}

ConstraintProgram without(ConstraintProgram program, std::size_t constraint) {
  program.constraints.erase(program.constraints.begin() + static_cast<std::ptrdiff_t>(constraint));
  return program;
}

}  // namespace

Result<std::vector<std::string>> conflict(const ConstraintProgram& program, const Room& room, const Stock& stock,
                                          const KindTable& kinds, const OptimiseOptions& options) {
  OptimiseOptions how = options;
  how.steps = std::min(how.steps, steps_each);
  how.chains = 1;
  how.on_progress = {};
  ConstraintProgram left = program;
  left.scores.clear();
  std::vector<std::string> names;
  const auto all = can_be_had(left, room, stock, kinds, how);
  if (!all) return all.error();
  if (*all) return names;
  for (std::size_t i = 0; i < left.constraints.size();) {
    const auto rest = can_be_had(without(left, i), room, stock, kinds, how);
    if (!rest) return rest.error();
    if (*rest) ++i;  // needed for the conflict
    else left = without(std::move(left), i);
  }
  for (const auto& [name, term] : left.constraints) names.push_back(name);
  return names;
}

}  // namespace roomgen::lab
