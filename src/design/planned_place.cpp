#include "planned_place.h"

#include "scene/judgement.h"

namespace roomgen::design {

Result<PlaceAdvice> place_as_planned(const PlaceRequest& request) {
  if (request.planned.item >= request.plan.items.size())
    return Error{Error::Kind::invalid_input,
                 "\"" + request.planned.id + "\" is no item of the plan"};
  const PlanItem& item = request.plan.items[request.planned.item];
  PlaceAdvice advice;
  advice.relations = known_relations(item.relations, request.scene.room, request.scene.objects);
  advice.location = item.location;
  advice.yaw = item.facing;
  advice.bottom = item.bottom;
  advice.usual = true;
  return advice;
}

}  // namespace roomgen::design
