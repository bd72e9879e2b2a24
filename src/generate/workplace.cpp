#include "workplace.h"

#include <algorithm>

#include "builder_steps.h"
#include "choose_assets.h"
#include "fit_openings.h"
#include "ready.h"
#include "retrieve.h"
#include "solve/place.h"

namespace roomgen {

Workplace::Workplace(Plan the_plan, Designer& the_designer, const AssetLibrary& the_library,
                     const KindTable& the_categories, BuildOptions the_options)
    : notes_given(the_plan.notes.size()),
      plan(ready(std::move(the_plan), the_categories)),
      roles(plan),
      carriers(composition::carriers(plan, the_categories)),
      designer(the_designer),
      library(the_library),
      categories(the_categories),
      options(std::move(the_options)),
      room(plan.room),
      layout(room, categories, models,
             built_in_arrangements() ? &*built_in_arrangements() : nullptr, options.place.weights) {}

Result<std::unique_ptr<Workplace>> open_workplace(Plan plan, Designer& designer,
                                                  const AssetLibrary& library,
                                                  const KindTable& categories,
                                                  BuildOptions options) {
  const auto& kinds = OpeningKinds::built_in();
  if (!kinds) return kinds.error();
  auto place = std::make_unique<Workplace>(std::move(plan), designer, library, categories,
                                           std::move(options));
  const Random random = Random(place->options.seed).fork("openings");
  auto used = fit_openings(place->room, *kinds, library, random);
  if (!used) return used.error();
  for (const auto& asset : *used)
    if (auto status = fetch_model(*place, asset); !status) return status.error();
  place->joinery = *std::move(used);
  if (auto status = check_assets(place->plan, library); !status) return status.error();
  if (place->designer.chooses()) measure_covers(*place);
  choose_assets(*place);
  return place;
}

namespace {

// Beyond what a room may hold the last ones are left out, those first that nobody asked for.
void leave_out_surplus(const Plan& plan, BuildState& state) {
  std::size_t kept = state.left.size();
  for (const bool asked : {false, true})
    for (std::size_t i = state.left.size(); i > 0 && kept > max_things_of_room; --i) {
      const PlannedObject& planned = state.left[i - 1];
      if (plan.items[planned.item].asked != asked) continue;
      state.reasons[planned.id] = "a room holds at most " + std::to_string(max_things_of_room) + " things";
      --kept;
    }
  std::erase_if(state.left, [&](const PlannedObject& planned) { return state.reasons.count(planned.id) > 0; });
}

void leave_out_unwanted(const Plan& plan, BuildState& state) {
  for (const auto& planned : planned_objects(plan))
    if (const auto& why = plan.items[planned.item].left_out; !why.empty())
      state.reasons[planned.id] = why;
  std::erase_if(state.left,
                [&](const PlannedObject& planned) { return state.reasons.count(planned.id) > 0; });
}

}  // namespace

BuildState first_state(const Workplace& place) {
  BuildState state;
  state.left = composition::placing_order(place.plan);
  leave_out_unwanted(place.plan, state);
  leave_out_surplus(place.plan, state);
  state.favourites = place.chosen;
  state.model_use = place.model_use;
  state.stopped = place.stopped;
  state.models = place.models;
  state.random = Random(place.options.seed).fork("placement");
  return state;
}

void take_up(BuildState& state, std::string_view id) {
  std::erase_if(state.left, [&](const PlannedObject& planned) { return planned.id == id; });
  if (state.next == id) state.next.clear();
}

void arrange_as(Layout& layout, const std::vector<Object>& objects) {
  const auto is_same = [](const Object& a, const Object& b) {
    return a.id == b.id && a.position == b.position && a.yaw == b.yaw && a.size == b.size &&
           a.on == b.on && a.relations == b.relations && a.locked == b.locked;
  };
  const auto standing = layout.objects();
  const auto first = static_cast<std::size_t>(
      std::mismatch(standing.begin(), standing.end(), objects.begin(), objects.end(), is_same).first -
      standing.begin());
  while (layout.objects().size() > first) {
    const std::string id = layout.objects().back().id;
    layout.remove(id);
  }
  for (std::size_t i = first; i < objects.size(); ++i) layout.add(objects[i]);
}

Scene scene_of(const Workplace& place, std::span<const Object> objects) {
  Scene scene;
  scene.prompt = place.plan.prompt;
  scene.seed = place.plan.seed;
  scene.room = place.room;
  scene.objects.assign(objects.begin(), objects.end());
  return scene;
}

Status fetch_model(Workplace& place, const AssetInfo& asset) {
  auto model = load_model(place.library, asset.ref);
  if (!model) return model.error();
  if (!asset_key(asset.ref).empty()) place.models.add(asset_key(asset.ref), *std::move(model));
  return {};
}

void enter(Work& work, const PlannedObject& planned, const AssetInfo& asset, PlacementTask task) {
  BuildState& state = work.state;
  if (const Object* standing = work.layout().find(planned.id)) {
    task.object.relations = standing->relations;
    task.usual = false;
  } else {
    task = with_leading_habit(work.layout(), std::move(task));
  }
  if (const Object* carrier = task.binding ? work.layout().find(task.object.on) : nullptr)
    task.carrier_then = {carrier->position.head<2>(), carrier->yaw};
  std::erase_if(state.tasks, [&](const PlacementTask& other) { return other.object.id == planned.id; });
  state.tasks.push_back(std::move(task));
  remember(state.favourites, work.item(planned), asset);
  state.assets[planned.id] = asset;
}

}  // namespace roomgen
