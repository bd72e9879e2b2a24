#include <algorithm>

#include "generate/asset_task.h"
#include "generate/retrieve.h"
#include "generate/window_cover.h"
#include "generate/written_thing.h"
#include "kinds/mounting.h"
#include "operations.h"
#include "placing.h"
#include "roomgen/base/text.h"
#include "scene/written_asset.h"
#include "solve/layout.h"

namespace roomgen {

namespace {

constexpr int most_assets = 3;  // that are tried for one thing
constexpr std::size_t most_things = 5000;  // in a scene

bool wants(const std::vector<Relation>& relations, RelationKind kind) {
  return std::any_of(relations.begin(), relations.end(), [&](const Relation& one) { return one.kind == kind; });
}

Result<Mount> mount_for(const Scene& scene, const Kind& kind, const edit::Add& add) {
  if (add.mount) return *add.mount;
  const bool is_free = is_of_no_kind(kind) || !add.program.empty();
  if (hook_of(scene, add.relations)) return Mount::ceiling;
  const bool rests = wants(add.relations, RelationKind::on) || wants(add.relations, RelationKind::inside);
  if (!rests) return kind.mount;
  if (is_free || may_be_put_up(kind, Mount::surface)) return Mount::surface;
  return cannot("a " + kind.name + " does not stand on other things");
}

PlanItem item_for(const Kind& kind, const edit::Add& add, Mount mount) {
  PlanItem item;
  item.category = is_of_no_kind(kind) ? lower(add.category) : kind.name;
  item.description = add.description.empty() ? add.category : add.description;
  item.size = add.size;
  item.quantity = add.count;
  item.mount = mount;
  item.asked = true;
  item.relations = add.relations;
  return item;
}

Result<std::string> room_for_new(const Draft& draft, const edit::Add& add) {
  if (add.room.empty())
    for (const auto& relation : add.relations)
      if (const Object* target = find_object(draft.scene, relation.target)) return target->room;
  return room_named(draft, add.room);
}

/// A thing that is to come, before it has a mesh and a place.
struct Newcomer {
  PlannedObject planned;
  PlanItem item;
  const Kind& kind;
  std::string room;
};

// Curtains are made to the measure of a window that has none.
Status hang_at_window(Draft& draft, const Newcomer& newcomer, const AssetInfo& asset, Object object) {
  const Room& room = room_with_id(draft.scene, newcomer.room);
  Layout& layout = draft.shop.layout(draft.scene, newcomer.room);
  const auto asked = [&](const Opening* window) {
    return newcomer.item.relations.empty() ||
           std::any_of(newcomer.item.relations.begin(), newcomer.item.relations.end(),
                       [&](const Relation& one) { return one.target == window->id; });
  };
  object.asset = asset.ref;
  object.mount = Mount::wall;
  std::string why;
  const auto height = newcomer.item.size ? std::optional(newcomer.item.size->z()) : std::nullopt;
  for (const Opening* window : windows_to_cover(room, layout.objects(), newcomer.item.category)) {
    if (!asked(window)) continue;
    for (const auto& hung : hangings(object, newcomer.kind, room, *window, height)) {
      auto place = settled(draft, layout, Cluster{hung, {}});
      if (place) return draft.put(*place), Status();
      why = " at " + window->id + ": " + place.error().message;
    }
  }
  return cannot("there is no room for it" + (why.empty() ? " at any window" : why));
}

/// How a newcomer may get its place.
enum class Means { usual_places, all_places, others_make_way };

Status place_newcomer(Draft& draft, const Newcomer& newcomer, const AssetInfo& asset, Means means) {
  const auto model = draft.shop.fetch_model(asset.ref);
  if (!model) return model.error();
  PlacementTask task = task_of_asset(newcomer.planned.id, newcomer.item, newcomer.kind, asset, model->get(),
                                     room_with_id(draft.scene, newcomer.room));
  Object& object = task.object;
  object.room = newcomer.room;
  if (newcomer.kind.covers_window) return hang_at_window(draft, newcomer, asset, object);
  Aim aim;
  aim.asked = newcomer.item.relations;
  aim.usual = true;
  auto cluster = object.mount == Mount::ceiling ? hung(draft, {object, {}}, aim.asked)
                                                : Result<Cluster>({object, {}});
  if (!cluster) return cluster.error();
  if (means == Means::others_make_way) return place_or_make_way(draft, *cluster, aim);
  auto found = find_place(draft, draft.layout_without(*cluster), *cluster, aim,
                          means == Means::usual_places ? Effort::brief : Effort::thorough);
  if (!found) return found.error();
  draft.put(*found);
  return {};
}

// What stands here already and was drawn for this room, where the library only guesses.
const Object* drawn_twin(const Draft& draft, const PlanItem& item) {
  const Object* twin = nullptr;
  for (const auto& object : draft.scene.objects) {
    if (!is_written(object.asset) || object.category != item.category) continue;
    if (!twin || object.description == item.description) twin = &object;
  }
  return twin;
}

// The assets that suit the words, in order; the last chance of the first one is that others make way.
Status bring(Draft& draft, Newcomer newcomer, Favourites& favourites) {
  const AssetSearch search{draft.shop.library(), draft.shop.kinds(), draft.scene.seed};
  auto assets = retrieve(search, favourites, newcomer.item, newcomer.planned, most_assets);
  const bool is_guess =
      assets && (assets->empty() || assets->front().stand_in || assets->front().approximate);
  if (const Object* twin = is_guess ? drawn_twin(draft, newcomer.item) : nullptr) {
    newcomer.item.asset = asset_key(twin->asset);
    if (!newcomer.item.size) newcomer.item.size = twin->size;
    assets = retrieve(search, favourites, newcomer.item, newcomer.planned, most_assets);
  }
  if (!assets) return assets.error();
  if (assets->empty())
    return cannot("no asset is a " + newcomer.item.category +
                  "; the library has none and none can be made of the words");
  for (const auto means : {Means::usual_places, Means::all_places})
    for (const auto& asset : *assets)
      if (place_newcomer(draft, newcomer, asset, means))
        return remember(favourites, newcomer.item, asset), Status();
  remember(favourites, newcomer.item, assets->front());
  return place_newcomer(draft, newcomer, assets->front(), Means::others_make_way);
}

}  // namespace

const Kind& kind_to_add(const KindTable& kinds, const edit::Add& add) {
  const Kind& kind = kinds.get(add.category);
  const bool rests = wants(add.relations, RelationKind::on) || wants(add.relations, RelationKind::inside);
  if (rests && kind.mount != Mount::surface && !kind.forms.small.empty())
    if (const Kind* small = kinds.by_name(kind.forms.small)) return kinds.planned(*small);
  return kind;
}

Status build_as_written(Draft& draft, const std::string& program, PlanItem& item) {
  auto thing = written_thing(draft.shop.library(), program, item, draft.scene.seed);
  if (!thing) return with_context(thing.error(), "/program");
  item.asset = asset_key(thing->asset.ref);
  item.size = thing->asset.size;
  for (const auto& note : thing->notes)
    draft.told.push_back(item.category + ", as written: " + note);
  return {};
}

bool is_of_no_kind(const Kind& kind) {
  return kind.name.empty() || kind.is_stand_in();
}

Status carry_out(Draft& draft, const edit::Add& add) {
  const Kind& kind = kind_to_add(draft.shop.kinds(), add);
  if (draft.scene.objects.size() + static_cast<std::size_t>(add.count) > most_things)
    return cannot("a scene holds " + std::to_string(most_things) + " things at most");
  const auto mount = mount_for(draft.scene, kind, add);
  if (!mount) return mount.error();
  const auto room = room_for_new(draft, add);
  if (!room) return room.error();
  if (auto status = check_targets(draft, *room, add.relations); !status) return status;
  PlanItem item = item_for(kind, add, *mount);
  if (!add.program.empty())
    if (auto status = build_as_written(draft, add.program, item); !status) return status;
  Favourites favourites;
  Requirement wish;
  for (int number = 0; number < add.count; ++number) {
    Newcomer newcomer{{"", 0, number}, item, kind, *room};
    newcomer.planned.id = next_id(draft.scene, newcomer.item.category);
    if (auto status = bring(draft, newcomer, favourites); !status) return status;
    const Object& object = *find_object(draft.scene, newcomer.planned.id);
    draft.added.push_back(object.id);
    draft.named.insert(object.id);
    if (number == 0) wish = wish_for(object, newcomer.item.description, Requirement::Kind::count);
    else wish.subjects.push_back(object.id);
    wish_relations(draft, object, add.relations);
    draft.new_categories.insert(object.category);
  }
  wish.count = add.count;
  wish.at_least = true;
  if (add.count > 1) wish.clause = std::to_string(add.count) + " " + wish.clause;
  draft.wishes.push_back(std::move(wish));
  if (kind.traits.flat) settle_heights(draft, *room);
  return {};
}

}  // namespace roomgen
