#include "ready.h"

#include "composition/plan_groups.h"
#include "roomgen/design/designer.h"

namespace roomgen {

Plan ready(Plan plan, const KindTable& kinds) {
  settle(plan);
  return composition::completed(std::move(plan), kinds);
}

}  // namespace roomgen
