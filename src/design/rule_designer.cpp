#include "brief/said_wish.h"
#include "plan/planning.h"
#include "planned_place.h"
#include "roomgen/design/designer.h"
#include "solve/arrangement.h"
#include "wish_check.h"

namespace roomgen {

namespace {

class RuleDesigner : public Designer {
 public:
  Result<Plan> plan(const PlanRequest& request) override {
    if (auto ready = design::check_knowledge(); !ready) return ready.error();
    if (auto status = design::check_request(request); !status) return status.error();
    const brief::Brief brief =
        brief::brief_of(request, *brief::built_in_room_kinds(), KindTable::built_in());
    if (auto status = design::check_understood(request, brief); !status) return status.error();
    return plan::make_plan(request, brief, *brief::built_in_room_kinds(), KindTable::built_in(),
                     *built_in_arrangements());
  }

  Result<PlaceAdvice> place(const PlaceRequest& request) override {
    return design::place_as_planned(request);
  }
};

}  // namespace

std::unique_ptr<Designer> make_rule_designer() {
  return std::make_unique<RuleDesigner>();
}

}  // namespace roomgen
