#include <algorithm>

#include "changed_thing.h"
#include "generate/asset_task.h"
#include "operations.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr std::size_t most_alternatives = 12;

bool is_same_mesh(const AssetRef& a, const AssetRef& b) {
  return a.library == b.library && a.id == b.id && a.procedural == b.procedural;
}

void rename_thing(Draft& draft, const std::string& from, const std::string& to) {
  for (auto& object : draft.scene.objects) {
    if (object.id == from) object.id = to;
    if (object.on == from) object.on = to;
    for (auto& relation : object.relations)
      if (relation.target == from) relation.target = to;
  }
}

AssetQuery query_for(const Object& object, const std::string& category, const edit::Replace& replace) {
  AssetQuery query;
  query.category = category;
  query.description = replace.description.empty() ? category : replace.description;
  if (category == object.category) query.size = object.size;
  query.mount = object.mount;
  query.asked = true;
  query.limit = most_alternatives;
  return query;
}

// The thing as another mesh makes it; its relations stay.
Object remade(const Draft& draft, const Object& object, const Kind& kind, const AssetInfo& asset, const Model* model,
              const std::string& description) {
  PlanItem item;
  item.category = kind.name.empty() ? object.category : kind.name;
  item.description = description;
  item.mount = object.mount;
  item.asked = true;
  item.relations = object.relations;
  Object made = task_of_asset(object.id, item, kind, asset, model, room_of(draft.scene, object)).object;
  made.position = object.position;
  made.yaw = object.yaw;
  made.on = object.on;
  made.room = object.room;
  made.locked = object.locked;
  return made;
}

// A finish of its own makes another one of the same mesh, where words ask for it.
bool is_another(const AssetMatch& match, const Object& object, bool has_words) {
  if (!is_same_mesh(match.asset.ref, object.asset)) return !has_words || match.contradicts == Contradiction::none;
  return has_words && match.contradicts == Contradiction::none && match.asset.ref.finish != object.asset.finish;
}

// Another kind of thing has another name, and its number is asked for.
void call_by_kind(Draft& draft, const std::string& old_id, const std::string& category,
                  const std::string& description) {
  const std::string id = next_id(draft.scene, category);
  rename_thing(draft, old_id, id);
  draft.named.insert(id);
  draft.added.push_back(id);
  Requirement wish = wish_for(*find_object(draft.scene, id), description.empty() ? category : description,
                              Requirement::Kind::count);
  wish.at_least = true;
  draft.wishes.push_back(std::move(wish));
}

}  // namespace

Status carry_out(Draft& draft, const edit::Replace& replace) {
  const auto object = object_to_change(draft, replace.object);
  if (!object) return object.error();
  const Kind& kind = draft.shop.kinds().get(replace.category.empty() ? object->category : replace.category);
  const std::string category = kind.name.empty() ? lower(replace.category) : kind.name;
  const bool is_other_kind = category != object->category;
  if (is_other_kind && kind.mount != object->mount &&
      std::find(kind.also.begin(), kind.also.end(), object->mount) == kind.also.end())
    return cannot("a " + category + " is not put up like " + object->id + "; remove the one and add the other");
  const auto matches = draft.shop.library().search(query_for(*object, category, replace));
  if (!matches) return matches.error();
  const std::string description = replace.description.empty() ? object->description : replace.description;
  std::string why = "there is no other " + category;
  for (const auto& match : *matches) {
    if (!is_another(match, *object, !replace.description.empty())) continue;
    const auto model = draft.shop.fetch_model(match.asset.ref);
    if (!model) return model.error();
    Draft trial = draft;
    const auto status = put_changed(trial, cluster_of(draft.scene, *object),
                                    remade(draft, *object, kind, match.asset, model->get(), description));
    if (!status) {
      why = status.error().message;
      continue;
    }
    draft.take_over(std::move(trial));
    draft.new_categories.insert({object->category, category});
    if (is_other_kind) call_by_kind(draft, object->id, category, replace.description);
    return {};
  }
  return cannot(object->id + " cannot be replaced: " + why);
}

}  // namespace roomgen
