#include "rugs.h"

#include "design/scene_text.h"
#include "roomgen/base/text.h"
#include "sizing.h"
#include "solve/fit_rugs.h"
#include "told.h"

namespace roomgen {

namespace {

// What is said of a rug: whether it may be cut, and what it is to be near to. A designer's stays.
RugWish rug_wish(const Workplace& place, const BuildState& state, const PlannedObject& planned) {
  const PlanItem& item = item_of(place, state, planned);
  const bool is_said = state.rugs.count(planned.id) > 0;
  RugWish wish{planned.id, item.asked || is_said,
               is_said || is_size_told(item, place.categories.get(item.category))};
  for (const auto& task : state.tasks)
    if (task.object.id == planned.id) wish.wishes = task.wishes, wish.place_told = task.binding;
  return wish;
}

std::vector<RugWish> rug_wishes(const Workplace& place, const BuildState& state) {
  std::vector<RugWish> wishes;
  for (const auto& planned : planned_objects(place.plan))
    wishes.push_back(rug_wish(place, state, planned));
  return wishes;
}

bool lies_alike(const Object& a, const Object& b) {
  return a.position == b.position && a.yaw == b.yaw && a.size == b.size;
}

}  // namespace

std::string change_of_rug(const Object& said, const Object& lies) {
  constexpr double unseen = 0.05;  // metres
  const double moved = (lies.position - said.position).head<2>().norm();
  const bool is_cut = (lies.size - said.size).cwiseAbs().maxCoeff() > unseen;
  if (moved <= unseen && !is_cut) return {};
  return (moved > unseen ? " was moved by " + format_number(moved, 2) + " m and is " : " is ") +
         design::size_text(lies.size) + " m, so that nothing stands on its edge";
}

void settle_rugs(Work& work, const Step* now) {
  auto& rugs = work.state.rugs;
  const auto standing = work.layout().objects();
  std::vector<Object> objects(standing.begin(), standing.end());
  for (auto& object : objects) {
    if (!object.traits.flat || object.mount != Mount::floor) continue;
    const bool is_fixed = object.locked && object.group.empty();
    const bool is_free = !is_fixed && is_said(work.state, object.id, now);
    if (!is_free) rugs.erase(object.id);
    object.locked = !is_free;
    if (!is_free) continue;
    const auto [known, is_new] = rugs.try_emplace(object.id, LaidRug{object, object});
    if (!is_new && !lies_alike(known->second.lies, object)) known->second = {object, object};
    object.position = known->second.said.position, object.size = known->second.said.size;
  }
  if (rugs.empty()) return;
  fit_rugs(work.place.room, objects, work.place.models, work.place.categories,
           rug_wishes(work.place, work.state));
  std::vector<Object> laid(standing.begin(), standing.end());
  for (auto& object : laid)
    if (const auto rug = rugs.find(object.id); rug != rugs.end()) {
      const Object& lies = *find_object(objects, object.id);
      object.position.head<2>() = lies.position.head<2>(), object.size = lies.size;
      rug->second.lies = object;
    }
  arrange_as(work.layout(), laid);
}

// Comes after all moves: until then things stand as if rugs had no height.
void lay_rugs(const Workplace& place, const BuildState& state, Generation& result) {
  const RugFit fit = fit_rugs(place.room, result.scene.objects, result.models, place.categories,
                              rug_wishes(place, state));
  for (const auto& [id, rug] : state.rugs) {
    const Object* lies = roomgen::find_object(result.scene, id);
    const auto change = lies ? change_of_rug(rug.said, *lies) : "";
    if (!change.empty()) result.notes.push_back(id + change);
  }
  for (const auto& id : fit.left_out)
    result.scene.unplaced.push_back({id, find_object(state.objects, id)->category,
                                     "wherever it lies, something stands on its edge"});
  for (const auto& id : fit.uneven)
    result.notes.push_back("something stands on the edge of " + id +
                           ", for it was asked for there");
}

}  // namespace roomgen
