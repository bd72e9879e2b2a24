#include <algorithm>
#include <cmath>

#include "create/finish_look.h"
#include "generate/asset_task.h"
#include "operations.h"
#include "placing.h"
#include "roomgen/base/text.h"
#include "scene/finish_words.h"

namespace roomgen {

namespace {

constexpr std::size_t most_alternatives = 12;
constexpr double slack_of_change = 0.5;   // metres that a changed thing may give way
constexpr double slack_on_top = 1.0;      // and what stands on it
constexpr double least_size = 0.02, greatest_size = 12.0;  // metres

bool is_same_mesh(const AssetRef& a, const AssetRef& b) {
  return a.library == b.library && a.id == b.id && a.procedural == b.procedural;
}

// Its back, its middle, or a side stays where it was.
std::vector<Pose> poses_for_size(const Object& before, const Vec3& size) {
  const Pose pose = pose_of(before);
  const Vec2 more = 0.5 * (size.head<2>() - before.size.head<2>());
  std::vector<Pose> poses;
  for (const Vec2& side : {Vec2(0, -1), Vec2(0, 0), Vec2(1, -1), Vec2(-1, -1), Vec2(1, 0), Vec2(-1, 0)}) {
    Pose moved = pose;
    moved.position += rotated(Vec2(side.cwiseProduct(more)), before.yaw);
    poses.push_back(moved);
  }
  return poses;
}

// What stood on it stands on it again, as near as can be to where it did.
Status reload(Draft& draft, const Cluster& before, const Object& carrier) {
  for (const auto& object : before.carried) {
    if (object.on != carrier.id) continue;  // comes with what carries it
    Cluster small{object, {}};
    for (const auto& other : before.carried)
      if (other.on == object.id) small.carried.push_back(other);
    Aim aim;
    aim.near_to = pose_of(object);
    aim.near_to->position += carrier.position.head<2>() - before.root.position.head<2>();
    aim.most_off = slack_on_top;
    aim.turns_freely = true;
    aim.kept = object.relations;
    auto place = find_place(draft, draft.layout_without(small), small, aim);
    if (!place) return cannot(object.id + " finds no place on it any more: " + place.error().message);
    draft.put(*place);
  }
  return {};
}

// The changed thing at its place, or a little aside; with all that stood on it.
Status put_changed(Draft& draft, const Cluster& before, Object changed) {
  auto away = before.ids();
  Layout& layout = draft.shop.layout(draft.scene, changed.room, away);
  Result<Cluster> place = cannot("");
  for (const auto edges : {RugEdges::kept_free, RugEdges::stood_on})
    for (const auto& pose : poses_for_size(before.root, changed.size))
      if (!place) place = settled(draft, layout, moved_to(Cluster{changed, {}}, pose), edges);
  if (!place) {
    Aim aim;
    aim.near_to = pose_of(before.root);
    aim.most_off = slack_of_change;
    aim.kept = changed.relations;
    const std::string why = place.error().message;
    place = find_place(draft, layout, Cluster{changed, {}}, aim);
    if (!place) return cannot(why);
  }
  place->root.relations = changed.relations;
  draft.take_out([&] {
    auto carried = away;
    carried.erase(before.root.id);
    return carried;
  }());
  draft.put(*place);
  for (const auto& object : before.carried) draft.named.insert(object.id);
  if (auto status = reload(draft, before, place->root); !status) return status;
  if (changed.traits.flat) settle_heights(draft, changed.room);
  return {};
}

// Puts things back into the order that they had: what was taken out for a while came to the end.
void restore_order(const std::vector<Object>& before, std::vector<Object>& objects) {
  const auto rank = [&](const Object& object) {
    const auto found = std::find_if(before.begin(), before.end(), [&](const Object& one) { return one.id == object.id; });
    return found - before.begin();
  };
  std::stable_sort(objects.begin(), objects.end(), [&](const Object& a, const Object& b) { return rank(a) < rank(b); });
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

}  // namespace

Status carry_out(Draft& draft, const edit::Replace& replace) {
  const auto object = object_to_change(draft, replace.object);
  if (!object) return object.error();
  const KindTable& kinds = draft.shop.kinds();
  const Kind& kind = kinds.get(replace.category.empty() ? object->category : replace.category);
  const std::string category = kind.name.empty() ? lower(replace.category) : kind.name;
  const bool is_other_kind = category != object->category;
  if (is_other_kind && kind.mount != object->mount && std::find(kind.also.begin(), kind.also.end(), object->mount) == kind.also.end())
    return cannot("a " + category + " is not put up like " + object->id + "; remove the one and add the other");
  const auto matches = draft.shop.library().search(query_for(*object, category, replace));
  if (!matches) return matches.error();
  const auto order = draft.scene.objects;
  const Cluster before = cluster_of(draft.scene, *object);
  std::string why = "there is no other " + category;
  for (const auto& match : *matches) {
    if (is_same_mesh(match.asset.ref, object->asset) && match.asset.ref.finish == object->asset.finish) continue;
    if (replace.description.empty() && is_same_mesh(match.asset.ref, object->asset)) continue;
    if (match.contradicts != Contradiction::none && !replace.description.empty()) continue;
    const auto model = draft.shop.fetch_model(match.asset.ref);
    if (!model) return model.error();
    Draft trial = draft;
    const auto status = put_changed(trial, before,
                                    remade(draft, *object, kind, match.asset, model->get(),
                                           replace.description.empty() ? object->description : replace.description));
    if (!status) {
      why = status.error().message;
      continue;
    }
    draft.scene = std::move(trial.scene);
    draft.named.merge(trial.named);
    restore_order(order, draft.scene.objects);
    draft.new_categories.insert({object->category, category});
    if (!is_other_kind) return {};
    const std::string id = next_id(draft.scene, category);
    rename_thing(draft, object->id, id);
    draft.named.insert(id);
    draft.added.push_back(id);
    Requirement wish = wish_for(*find_object(draft.scene, id), replace.description.empty() ? category : replace.description,
                                Requirement::Kind::count);
    wish.at_least = true;
    draft.wishes.push_back(std::move(wish));
    return {};
  }
  return cannot(object->id + " cannot be replaced: " + why);
}

Status carry_out(Draft& draft, const edit::Resize& resize) {
  const auto object = object_to_change(draft, resize.object);
  if (!object) return object.error();
  if (resize.size.minCoeff() < least_size || resize.size.maxCoeff() > greatest_size)
    return cannot("a size of " + size_text(resize.size) + " m is not possible for " + object->id);
  Object changed = *object;
  for (int axis = 0; axis < 3; ++axis) changed.size[axis] = resize.size[axis];
  if (const auto model = draft.shop.models().find(asset_key(object->asset)); model && changed.traits.round)
    changed.traits.round = keeps_to_ellipse(*model, changed.size);
  const auto order = draft.scene.objects;
  if (auto status = put_changed(draft, cluster_of(draft.scene, *object), changed); !status) return status;
  restore_order(order, draft.scene.objects);
  return {};
}

Status carry_out(Draft& draft, const edit::Recolor& recolor) {
  const auto object = object_to_change(draft, recolor.object);
  if (!object) return object.error();
  const auto finish = create::wanted_finish(recolor.looks, object->category);
  if (finish.empty())
    return Error{Error::Kind::not_understood, "\"" + recolor.looks + "\" names no colour, material or pattern that is known"};
  if (object->asset.is_box()) return cannot(object->id + " is a plain box and cannot be painted");
  Object changed = *object;
  for (const auto& [stuff, text] : finish) changed.asset.finish[stuff] = text;
  if (const auto model = draft.shop.fetch_model(changed.asset); !model) return model.error();
  draft.put(Cluster{changed, {}});
  Requirement wish = wish_for(changed, recolor.looks + " " + changed.id, Requirement::Kind::attribute);
  wish.attribute = recolor.looks;
  draft.wishes.push_back(std::move(wish));
  return {};
}

Status carry_out(Draft& draft, const edit::Lock& lock) {
  for (const auto& id : lock.objects) {
    auto object = object_named(draft, id);
    if (!object) return object.error();
    object->locked = lock.locked;
    draft.put(Cluster{*object, {}});
  }
  return {};
}

Status carry_out(Draft& draft, const edit::Revert&) {
  if (!draft.earlier) return cannot("there is no edit before that could be taken back");
  draft.scene = *draft.earlier;
  return {};
}

Status carry_out(Draft& draft, const edit::Cover& cover) {
  const auto room = room_named(draft, cover.room);
  if (!room) return room.error();
  auto pieces = words(cover.looks);
  if (std::none_of(pieces.begin(), pieces.end(), [](const auto& word) { return finish_words().describes(word); }))
    return Error{Error::Kind::not_understood, "\"" + cover.looks + "\" names no colour or material that is known"};
  Room& changed = draft.scene.rooms.empty()
                      ? draft.scene.room
                      : *std::find_if(draft.scene.rooms.begin(), draft.scene.rooms.end(),
                                      [&](const Room& one) { return one.id == *room; });
  RoomMaterials& materials = changed.materials;
  struct Part {
    std::string_view name;
    std::string& words;
    std::string noun;
  };
  for (const auto& part : {Part{"floor", materials.floor, "floor"}, Part{"walls", materials.walls, "walls"},
                           Part{"ceiling", materials.ceiling, "ceiling"}, Part{"accent wall", materials.accent, "wall"}}) {
    if (part.name != cover.part) continue;
    part.words = cover.looks + " " + part.noun;
    Requirement wish;
    wish.kind = Requirement::Kind::attribute;
    wish.source = Requirement::Source::edit;
    wish.category = cover.part;
    wish.attribute = part.words;
    wish.clause = part.words;
    wish.room = *room;
    draft.wishes.push_back(std::move(wish));
    draft.new_categories.insert(cover.part);
    return {};
  }
  return cannot("\"" + cover.part + "\" is none of floor, walls, accent wall, ceiling");
}

}  // namespace roomgen
