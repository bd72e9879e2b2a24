#include "holding.h"

namespace roomgen::design {

double gap_to(const Placed& placed, const Target& target) {
  return gap(placed.footprint, target.footprint);
}

std::vector<ResolvedRelation> resolve_all(const Sketch& sketch, Object self,
                                          const std::vector<Relation>& relations) {
  self.relations = relations;
  return roomgen::resolve(self, sketch.room(), sketch.objects(), sketch.categories());
}

bool holds(const Sketch& sketch, const Placed& placed, const ResolvedRelation& relation) {
  const Subject subject{placed.footprint, placed.bottom, placed.bottom + placed.self->size.z()};
  return judge(relation, subject, sketch.room()).held;
}

}  // namespace roomgen::design
