#pragma once

#include <memory>
#include <span>
#include <vector>

#include "build_state.h"
#include "composition/plan_groups.h"
#include "roomgen/generate/room_builder.h"
#include "solve/layout.h"

namespace roomgen {

/// What the steps of one room work with. It stays the same but for caches, and but for the layout, which
/// stands as the state at work says. Nothing of it is shared with other rooms.
struct Workplace {
  Workplace(Plan the_plan, Designer& the_designer, const AssetLibrary& the_library,
            const KindTable& the_categories, BuildOptions the_options);
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  std::size_t notes_given;  ///< of the plan, before it was ready()
  Plan plan;                ///< ready()
  composition::Roles roles;
  std::map<std::string, std::string> carriers;     ///< composition::carriers()
  Designer& designer;
  const AssetLibrary& library;
  const KindTable& categories;
  BuildOptions options;
  Room room;                        ///< the plan's, with meshes in its openings
  std::vector<AssetInfo> joinery;   ///< assets of the openings
  ModelTable models;                ///< of the openings and of all that was tried
  Layout layout;

  // Of the choice of assets, before the first step.
  std::vector<ChoiceRound> choices;
  std::map<std::string, AssetInfo> chosen;  ///< by asset_key(): Favourites of the first step
  ModelUse model_use;
  std::string stopped;
};

/// Doors and windows get their meshes first: what stands before them shall know them.
Result<std::unique_ptr<Workplace>> open_workplace(Plan plan, Designer& designer,
                                                  const AssetLibrary& library,
                                                  const KindTable& categories,
                                                  BuildOptions options);

/// An empty room of which everything is left to do.
BuildState first_state(const Workplace& place);

/// Makes the layout stand as these objects say, in their order.
void arrange_as(Layout& layout, const std::vector<Object>& objects);

/// As the plan has it, or the designer says of this one.
inline const PlanItem& item_of(const Workplace& place, const BuildState& state,
                               const PlannedObject& planned) {
  const auto amended = state.amended.find(planned.id);
  return amended == state.amended.end() ? place.plan.items[planned.item] : amended->second;
}

/// One call at work: where, from and to which state, and what stops it.
struct Work {
  Workplace& place;
  BuildState& state;
  CancelToken cancel;

  Layout& layout() const { return place.layout; }
  const PlanItem& item(const PlannedObject& planned) const { return item_of(place, state, planned); }
  const Kind& category(const PlannedObject& planned) const {
    return place.categories.get(item(planned).category);
  }
  const composition::Role* role_of(const std::string& id) const { return place.roles.of(id); }
  PlaceOptions place_options() const {
    PlaceOptions options = place.options.place;
    options.cancel = cancel;
    return options;
  }
};

/// A room with these objects, as far as it is known while it is built.
Scene scene_of(const Workplace& place, std::span<const Object> objects);

/// The mesh of an asset, kept for the room.
Status fetch_model(Workplace& place, const AssetInfo& asset);

/// Takes an object into the room's books: it will have this asset and this task.
void enter(Work& work, const PlannedObject& planned, const AssetInfo& asset, PlacementTask task);

}  // namespace roomgen
