#include "told.h"

#include <set>

#include "composition/patterns.h"
#include "design/scene_text.h"
#include "library/asset_object.h"
#include "roomgen/base/text.h"
#include "rugs.h"

namespace roomgen {

namespace {

constexpr double off_said = 1.05;   // by this factor a length is another one than a designer's
constexpr double told_from = 0.05;  // metres

bool is_off(const Vec3& have, const Vec3& wanted) {
  const Vec3 unusual = Vec3::Constant(1e-3);
  return far_off_side(have, unusual, wanted, off_said).has_value();
}

const StandingGroup* group_about(const BuildState& state, const std::string& id) {
  for (const auto& group : state.groups)
    if (group.posts.count(id) > 0 && group.anchor.object.id != id) return &group;
  return nullptr;
}

std::string place_told(const BuildState& state, const PlacementTask& task, const Object& standing) {
  const bool is_said_there = is_said(state, standing.id) && !is_in_row(step_of(state, standing.id));
  if (!task.location || !is_said_there) return {};
  const double away = (standing.position.head<2>() - *task.location).norm();
  const char* from =
      group_about(state, standing.id) ? "its place in its group" : "where you put it";
  return away > told_from ? " stands " + format_number(away, 2) + " m from " + from : "";
}

// What of its last answer is not so, unless that is what it was asked about again.
void tell_answers(const Work& work, std::vector<std::string>& told) {
  for (const auto& step : work.state.trace) {
    if (step.attempts.empty()) continue;
    const Attempt& last = step.attempts.back();
    if (!last.refused.empty() && !step.repaired && work.layout().find(step.planned.id))
      told.push_back("your second answer for " + step.planned.id +
                     " was not taken: " + last.refused);
    if (!last.objections.empty())
      told.push_back("of your answer for " + step.planned.id + ": " + join(last.objections, "; "));
    if (const auto other = other_carrier(work.state, step, work.layout().objects()); !other.empty())
      told.push_back(step.planned.id + other);
  }
}

bool rests_on(std::span<const Object> objects, const Object* object, const std::string& carrier) {
  while (object && object->on != carrier) object = find_object(objects, object->on);
  return object != nullptr;
}

void tell_places(const Work& work, std::vector<std::string>& told) {
  std::set<std::string> changed;
  for (const auto& [id, rug] : work.state.rugs)
    if (const auto change = change_of_rug(rug.said, rug.lies); !change.empty())
      changed.insert(id), told.push_back(id + change);
  for (const auto& task : work.state.tasks) {
    const Object* standing = work.layout().find(task.object.id);
    const bool is_told = !standing || changed.count(standing->id) > 0;
    const std::string away = is_told ? "" : place_told(work.state, task, *standing);
    if (!away.empty()) told.push_back(standing->id + away);
  }
}

void tell_sizes(const Work& work, std::vector<std::string>& told) {
  std::set<std::pair<std::size_t, std::string>> sizes;  // once for things of one item
  for (const auto& planned : planned_objects(work.place.plan)) {
    const Object* standing = work.layout().find(planned.id);
    if (!standing) continue;
    const std::string size = other_size(work.place, work.state, planned, *standing);
    if (!size.empty() && sizes.emplace(planned.item, size).second)
      told.push_back(planned.id + " is " + size);
    if (work.category(planned).covers_window)
      told.push_back(planned.id + " is made to its window: " +
                     design::size_text(standing->size) + " m");
  }
}

}  // namespace

const Step* step_of(const BuildState& state, const std::string& id) {
  for (const auto& step : state.trace)
    if (step.planned.id == id) return &step;
  return nullptr;
}

bool is_in_row(const Step* step) {
  return step && !step->attempts.empty() && step->attempts.back().answer.spread;
}

bool is_said(const BuildState& state, const std::string& id, const Step* now) {
  if (const StandingGroup* group = group_about(state, id))
    return is_said(state, group->anchor.object.id, now);
  const Step* step = now && now->planned.id == id ? now : step_of(state, id);
  return step && !step->attempts.empty() && !step->attempts.back().answer.usual;
}

Said said_of(const BuildState& state, const Step& step) {
  for (const auto& group : state.groups)
    if (const auto post = group.posts.find(step.planned.id); post != group.posts.end()) {
      const Object& anchor = group.anchor.object;  // where it was put
      const composition::Place frame{anchor.position.head<2>(), anchor.yaw};
      Said said{composition::within(frame, post->second.place).position, post->second.carrier};
      if (post->second.spread) said.location.reset();
      return said;
    }
  if (step.attempts.empty() || step.attempts.front().answer.consultation.calls > 0) return {};
  Said said{step.attempts.front().answer.location, {}};
  if (is_in_row(&step)) said.location.reset();
  for (const auto& relation : step.attempts.front().answer.relations)
    if (relation.kind == RelationKind::on) said.carrier = relation.target;
  return said;
}

std::string other_carrier(const BuildState& state, const Step& step,
                          std::span<const Object> objects) {
  const Object* object = find_object(objects, step.planned.id);
  const std::string carrier = said_of(state, step).carrier;
  if (!object || object->on.empty() || carrier.empty() || rests_on(objects, object, carrier))
    return {};
  std::string why = "that had no room for it";
  for (const auto& attempt : step.attempts)
    if (attempt.refused.find(carrier) != std::string::npos) why = attempt.refused;
  return " stands on " + object->on + ", not on " + carrier + ": " + why;
}

std::string other_size(const Workplace& place, const BuildState& state,
                       const PlannedObject& planned, const Object& placed) {
  static constexpr const char* sides[] = {"wide", "deep", "high"};
  const PlanItem& item = item_of(place, state, planned);
  const Kind& kind = place.categories.get(item.category);
  if (!item.size || kind.covers_window || !item.tilt.isZero()) return {};
  const auto& wanted = *item.size;
  if (is_said(state, planned.id)) {  // what it said counts even where it is the usual size
    const auto rug = state.rugs.find(planned.id);
    Vec3 size = rug == state.rugs.end() ? placed.size : rug->second.said.size;  // not as cut
    size.z() *= 1.0 - placed.asset.wires;
    const bool is_other = is_off(size, wanted) &&
                          (placed.traits.front || is_off(size, {wanted.y(), wanted.x(), wanted.z()}));
    return is_other ? design::size_text(size) + " m, not " + design::size_text(wanted) : "";
  }
  if (kind.traits.flat) return {};
  const auto side = far_off_side(placed.size, kind.size, wanted);
  if (!side) return {};
  return format_number(placed.size[*side], 2) + " m " + sides[*side] + ", not " +
         format_number(wanted[*side], 2);
}

std::vector<std::string> told_of(const Work& work) {
  std::vector<std::string> told;
  for (const auto& round : work.place.choices)
    for (const auto& note : round.notes) told.push_back("of what you chose, " + note);
  for (const auto& step : work.state.trace)
    if (!step.reason.empty() && !work.layout().find(step.planned.id))
      told.push_back(step.planned.id + " is not there: " + step.reason);
  tell_answers(work, told);
  tell_places(work, told);
  tell_sizes(work, told);
  return told;
}

}  // namespace roomgen
