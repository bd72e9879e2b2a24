#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "roomgen/lab/program.h"

namespace roomgen::lab {

/// Numbers for sets, equal for those that say the same. Each set is looked at once: it is known by where it is
/// in its program.
class SetIds {
 public:
  std::size_t of(const ProgramSet& set);
  /// With the variables that are in force for it.
  using Key = std::vector<std::pair<std::string, std::size_t>>;
  Key key(const ProgramSet& set, const std::vector<std::pair<std::string, const ProgramSet*>>& variables);

 private:
  std::map<const ProgramSet*, std::size_t> known_;
  std::map<std::string, std::size_t> texts_;
};

}  // namespace roomgen::lab
