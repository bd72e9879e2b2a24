#include "together.h"

#include <algorithm>
#include <map>

#include "composition/plan_groups.h"
#include "roomgen/base/text.h"
#include "roomgen/kinds/kind_table.h"
#include "scene_text.h"

namespace roomgen::design {

namespace {

constexpr std::size_t most_on_one = 8;    ///< things on one carrier that one answer places
constexpr std::size_t most_of_room = 20;  ///< on the floor, or that hang

bool hangs(const PlanItem& item) { return item.mount == Mount::wall || item.mount == Mount::ceiling; }

bool belong_together(const PlanItem& one, const PlanItem& other, ModelSteps steps) {
  if (one.mount == Mount::surface || other.mount == Mount::surface)
    return one.mount == other.mount && !one.on.empty() && one.on == other.on;
  return steps == ModelSteps::groups && hangs(one) == hangs(other);
}

}  // namespace

std::vector<PlannedObject> answered_together(const PlaceRequest& request, ModelSteps steps,
                                             const std::set<std::string>& answered) {
  const PlanItem& own = request.plan.items[request.planned.item];
  const std::size_t most = own.mount == Mount::surface ? most_on_one : most_of_room;
  const auto with_group = request.with_group ? request.with_group() : std::set<std::string>();
  std::vector<PlannedObject> found;
  for (auto& planned : planned_objects(request.plan)) {
    const bool waits = planned.id != request.object.id && answered.count(planned.id) == 0 &&
                       std::find(request.later.begin(), request.later.end(), planned.id) != request.later.end();
    if (waits && with_group.count(planned.id) == 0 && found.size() < most &&
        belong_together(own, request.plan.items[planned.item], steps))
      found.push_back(std::move(planned));
  }
  return found;
}

std::map<std::string, Vec2> places_in_rows(
    const std::vector<std::pair<std::string, PlaceAdvice>>& answers, const Scene& scene) {
  std::map<std::string, std::vector<std::string>> rows;  // by carrier
  for (const auto& [id, answer] : answers)
    if (!answer.location && answer.relations.size() == 1 &&
        answer.relations.front().kind == RelationKind::on)
      rows[answer.relations.front().target].push_back(id);
  std::map<std::string, Vec2> places;
  for (const auto& [carrier_id, ids] : rows) {
    const Object* carrier = find_object(scene, carrier_id);
    if (!carrier || ids.size() < 2) continue;
    const Footprint top = footprint(*carrier);
    const int along = top.half().x() >= top.half().y() ? 0 : 1;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      Vec2 at = Vec2::Zero();
      at[along] = ((2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(ids.size()) - 1.0) * top.half()[along];
      places[ids[i]] = top.to_world(at);
    }
  }
  return places;
}

std::string group_text(const Plan& plan, const PlannedObject& planned) {
  const composition::Roles roles(plan);
  const auto* role = roles.of(planned.id);
  const PlanGroup* group = role && role->is_anchor ? composition::find_group(plan, role->group) : nullptr;
  if (!group) return "";
  const auto ways = composition::ways_to_stand(plan, *group, KindTable::built_in(), {});
  if (!ways || ways->empty() || ways->front().members.size() < 2) return "";
  std::map<std::string, int> kinds;
  for (const auto& member : ways->front().members) ++kinds[member.category];
  --kinds[ways->front().members.front().category];
  std::vector<std::string> brings;
  for (const auto& [kind, count] : kinds)
    if (count > 0) brings.push_back(std::to_string(count) + " " + kind);
  Bounds2 box = composition::box_of(ways->front(), KindTable::built_in());
  const Vec2 half = 0.5 * ways->front().members.front().size.head<2>();
  box.add(half), box.add(-half);
  const auto metres = [](double value) { return format_number(value, 2); };
  return "; it is the middle of a group and brings along " + join(brings, ", ") + ". Seen along its own front, the group reaches " +
         metres(-box.low.y()) + " m to the front of its middle, " + metres(box.high.y()) + " m behind it, " +
         metres(box.high.x()) + " m to its left, " + metres(-box.low.x()) + " m to its right";
}

std::string line_of(const Plan& plan, const PlannedObject& planned) {
  const PlanItem& item = plan.items[planned.item];
  const Vec3 size = item.size.value_or(KindTable::built_in().get(item.category).size);
  return planned.id + ": " + item.description + ", about " + size_text(size) + " m" + group_text(plan, planned);
}

}  // namespace roomgen::design
