#include <algorithm>

#include "create/finish_look.h"
#include "create/repaint.h"
#include "draft_changes.h"
#include "operations.h"
#include "roomgen/base/text.h"
#include "scene/finish_words.h"
#include "scene/wall_sides.h"

namespace roomgen {

Status carry_out(Draft& draft, const edit::Resize& resize) {
  const auto object = object_to_change(draft, resize.object);
  if (!object) return object.error();
  auto changed = with_size(draft, *object, resize.size);
  if (!changed) return changed.error();
  return put_changed(draft, cluster_of(draft.scene, *object), *std::move(changed));
}

namespace {

constexpr double least_seen = 0.01;  // share of a thing's surface

// Wood does not become glass: what would not be seen on this mesh is not done.
Status check_paintable(Draft& draft, const Object& object, const std::map<std::string, std::string>& finish,
                       const std::string& looks) {
  AssetRef plain = object.asset;
  plain.finish.clear();
  const auto model = draft.shop.fetch_model(plain);
  if (!model) return model.error();
  if (!*model) return {};
  for (const auto& [stuff, share] : create::painted_shares(**model, finish))
    if (share < least_seen)
      return cannot("no part of " + object.id + " can be \"" + looks + "\"; another " + object.category +
                    " may be: say \"replace " + object.id + " with a " + looks + " " + object.category + "\"");
  return {};
}

}  // namespace

Status carry_out(Draft& draft, const edit::Recolor& recolor) {
  const auto object = object_to_change(draft, recolor.object, true);
  if (!object) return object.error();
  auto finish = create::wanted_finish(recolor.looks, object->category);
  // An apple's description does not paint it; who asks for it does.
  if (finish.empty()) finish = create::wanted_finish(recolor.looks, "");
  if (finish.empty())
    return Error{Error::Kind::not_understood,
                 "\"" + recolor.looks + "\" names no colour, material or pattern that is known"};
  if (object->asset.is_box()) return cannot(object->id + " is a plain box and cannot be painted");
  if (auto status = check_paintable(draft, *object, finish, recolor.looks); !status) return status;
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
  Room& changed = room_with_id(draft.scene, *room);
  RoomMaterials& materials = changed.materials;
  if (cover.part.starts_with("wall-") && !walls_named(changed, cover.part).empty()) {
    // The first of those that mean a wall counts.
    std::erase_if(materials.covers, [&](const WallCover& one) { return one.wall == cover.part; });
    materials.covers.insert(materials.covers.begin(), {cover.part, cover.looks + " wall", {}});
    return {};
  }
  for (const std::string_view part : {"floor", "walls", "ceiling", "accent wall"}) {
    if (part != cover.part) continue;
    std::string& said = part == "floor"     ? materials.floor
                        : part == "walls"   ? materials.walls
                        : part == "ceiling" ? materials.ceiling
                                            : cover_named(materials, accent_name).finish;
    said = cover.looks + (part == "accent wall" ? " wall" : " " + cover.part);
    Requirement wish;
    wish.kind = Requirement::Kind::attribute;
    wish.source = Requirement::Source::edit;
    wish.category = cover.part;
    wish.attribute = said;
    wish.clause = said;
    wish.room = *room;
    draft.wishes.push_back(std::move(wish));
    draft.new_categories.insert(cover.part);
    return {};
  }
  return cannot("\"" + cover.part + "\" is none of floor, walls, accent wall, ceiling, and no wall of the room");
}

Status carry_out(Draft& draft, const edit::Light& light) {
  const auto room = room_named(draft, light.room);
  if (!room) return room.error();
  const auto is_known = [&](const std::string& lamp) {
    return lamp == "all" || find_object(draft.scene, lamp) || draft.shop.kinds().by_name(lamp);
  };
  if (light.light.lamps)
    for (const auto& lamp : *light.light.lamps)
      if (!is_known(lamp)) return cannot("there is no lamp \"" + lamp + "\" in the room");
  Lighting& now = room_with_id(draft.scene, *room).light;
  const Lighting& said = light.light;
  if (said.hour) now.hour = said.hour;
  if (said.sky) now.sky = said.sky;
  if (said.lux) now.lux = said.lux;
  if (said.kelvin) now.kelvin = said.kelvin;
  if (said.lamps) now.lamps = said.lamps;
  return {};
}

}  // namespace roomgen
