#pragma once

#include <cstddef>

#include "workplace.h"

namespace roomgen {

/// May things of this kind carry what shall stand on a `wanted` one (a category or id; empty: whatever
/// usually carries things)?
bool could_carry(const KindTable& categories, const std::string& category,
                 const std::string& wanted);

/// Finds what carries a small thing: what its relations name, else the placed thing of the wanted kind, or
/// a table or cabinet, with the most free places; if all are full, the one that could carry it, which
/// then says why it does not. The more often it was `refused`, the further this goes: it gets smaller, and
/// stands on something else rather than nowhere.
Status put_on_support(const Work& work, const PlanItem& item, std::size_t refused, Object& object);

}  // namespace roomgen
