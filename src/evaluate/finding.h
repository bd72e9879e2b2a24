#pragma once

#include <string>
#include <utility>

#include "roomgen/scene/requirement.h"

namespace roomgen {

/// What a clause was found to be, and why.
struct Finding {
  Compliance compliance = Compliance::met;
  std::string reason;  ///< for people; empty if it is met
};

/// Met where there is no fault.
inline Finding by_fault(std::string fault) {
  return {fault.empty() ? Compliance::met : Compliance::not_met, std::move(fault)};
}

}  // namespace roomgen
