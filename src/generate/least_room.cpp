#include "least_room.h"

#include "brief/outline.h"
#include "brief/room_kinds.h"
#include "plan/room_makers.h"
#include "plan/room_openings.h"

namespace roomgen {

namespace {

constexpr int most_steps = 25;  // each is a whole room to furnish

Plan in_rectangle(const Plan& plan, const Vec2& size) {
  Plan other = plan;
  other.room.polygon = brief::rectangle_of(size).polygon;
  other.room.openings.clear();
  if (const auto& kinds = brief::built_in_room_kinds())
    plan::ensure_door(other.room, kinds->get(plan.room.type), other.notes);
  return other;
}

// Furnished unseen.
bool is_what_it_is_called(const Plan& plan, const AssetLibrary& library,
                          const KindTable& categories, BuildOptions options) {
  options.on_event = {};
  options.renderer = nullptr;
  options.tells_least = false;
  const auto designer = make_rule_designer();
  return generate(plan, *designer, library, categories, options) && !options.cancel.cancelled();
}

}  // namespace

Error with_least_room(const Error& too_small, const Plan& plan, const AssetLibrary& library,
                      const KindTable& categories, const BuildOptions& options) {
  const auto works = [&](const Vec2& size) {
    return is_what_it_is_called(in_rectangle(plan, size), library, categories, options);
  };
  return plan::with_least(
      too_small, plan::least_size(bounds(plan.room.polygon).size(), works, most_steps));
}

Error with_least_size(const Error& too_small, const PlanRequest& request,
                      const AssetLibrary& library, const KindTable& categories,
                      const BuildOptions& options) {
  const auto start = request.size ? request.size : plan::told_least(too_small);
  if (too_small.kind != Error::Kind::too_small || !start) return too_small;
  const auto designer = make_rule_designer();
  const auto works = [&](const Vec2& size) {
    PlanRequest other = request;
    other.size = size;
    other.room.reset();
    const auto plan = designer->plan(other);
    return plan && is_what_it_is_called(*plan, library, categories, options);
  };
  return plan::with_least(too_small, plan::least_size(*start, works, most_steps));
}

}  // namespace roomgen
