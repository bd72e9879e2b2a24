#include "told.h"

#include <set>

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

std::string place_told(const BuildState& state, const PlacementTask& task, const Object& standing) {
  const bool is_said_there = is_said(state, standing.id) && !is_in_row(step_of(state, standing.id));
  if (!task.location || !is_said_there) return {};
  const double away = (standing.position.head<2>() - *task.location).norm();
  return away > told_from ? " stands " + format_number(away, 2) + " m from where you put it" : "";
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
  for (const auto& group : state.groups)
    if (group.posts.count(id) > 0 && group.anchor.object.id != id)
      return is_said(state, group.anchor.object.id, now);
  const Step* step = now && now->planned.id == id ? now : step_of(state, id);
  return step && !step->attempts.empty() && !step->attempts.back().answer.usual;
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
  tell_places(work, told);
  tell_sizes(work, told);
  return told;
}

}  // namespace roomgen
