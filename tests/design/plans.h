#pragma once

#include <string>

#include "roomgen/design/designer.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::test {

inline Plan plan_of(const std::string& prompt, std::uint64_t seed = 0) {
  PlanRequest request;
  request.prompt = prompt;
  request.seed = seed;
  return *make_rule_designer()->plan(request);
}

/// How many things of a category a plan holds, descendants included.
inline int count_of(const Plan& plan, const std::string& category) {
  int count = 0;
  for (const auto& item : plan.items)
    if (KindTable::built_in().is_a(item.category, category)) count += item.quantity;
  return count;
}

inline const char* const room_types[] = {"bedroom",  "living room", "kitchen",
                                         "bathroom", "dining room", "balcony"};

}  // namespace roomgen::test
