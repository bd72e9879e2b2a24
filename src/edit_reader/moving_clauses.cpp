#include <algorithm>

#include "clause.h"
#include "clause_parts.h"
#include "edit/operations.h"

namespace roomgen {

namespace {

constexpr double row_gap = 0.05;     // metres between things that are put in a row
constexpr double usual_shift = 0.5;  // metres, where nobody says how far

// What stands for the nearest wall is that of each.
Ids named_ends(const EditText& text, const Object& object, const Ids& ends) {
  return ends == Ids{nearest_of_walls} ? Ids{nearest_wall(text, object)} : ends;
}

// Straight towards the ends, or away from them.
Result<Vec3> straight_way(const EditText& text, const Object& object, const Ids& ends, double sign) {
  Vec3 way = Vec3::Zero();
  for (const auto& end : ends) way.head<2>() += middle_of_target(text, object, end) - Vec2(object.position.head<2>());
  if (way.norm() < 1e-6) return not_understood("it is not clear which way " + object.id + " shall move");
  return Vec3(sign * way.normalized());
}

}  // namespace

ReadClause read_shift(const EditText& text, const Ids& ids, const Shifting& how, bool group) {
  Clause clause;
  clause.about = ids;
  clause.end = how.end;
  for (const auto& id : ids) {
    const Object* object = find_object(text.scene, id);
    if (!object) return not_understood(id + " has no place yet from which it could move");
    const Ids ends = named_ends(text, *object, how.from.empty() ? how.towards : how.from);
    if (!how.metres && !how.direction && how.forward == 0.0) {
      edit::Move move{id, {}, group};
      for (const auto& end : ends)
        move.relations.push_back({how.from.empty() ? RelationKind::near : RelationKind::far, end});
      clause.operations.push_back(move);
      continue;
    }
    if (how.forward != 0.0) {
      const Vec2 front = rotated(Vec2(0.0, -how.forward), object->yaw) * how.metres.value_or(usual_shift);
      clause.operations.push_back(edit::Shift{id, Vec3(front.x(), front.y(), 0.0), group});
      continue;
    }
    const auto direction =
        how.direction ? Result<Vec3>(*how.direction) : straight_way(text, *object, ends, how.from.empty() ? 1.0 : -1.0);
    if (!direction) return direction.error();
    const double usual = direction->z() != 0.0 ? usual_lift : usual_shift;
    clause.operations.push_back(edit::Shift{id, *direction * how.metres.value_or(usual), group});
  }
  return clause;
}

namespace {

// "facing the window"
std::size_t read_facing(const EditText& text, std::size_t at, Clause& clause) {
  const auto length = longest_in(text.edits.faces, text.tokens, at);
  if (length == 0) return at;
  const auto target = target_at(text, at + length, clause.about);
  if (!target || !*target) return at;
  for (const auto& id : clause.about) clause.operations.push_back(edit::Face{id, (*target)->id});
  return (*target)->end;
}

// "and bring its chairs along", behind the place
std::size_t along_behind(const EditText& text, std::size_t at) {
  const std::size_t begin = text.behind_comma(at);
  const auto length = longest_in(text.edits.along, text.tokens, begin);
  return length > 0 ? begin + length - at : 0;
}

// "the table with its chairs to the window": the words behind the thing are taken off.
bool takes_group_along(const EditText& text, Read<Ids>& what) {
  const auto length = longest_in(text.edits.along, text.tokens, what.end);
  what.end += length;
  return length > 0;
}

bool are_small(const EditText& text, const Ids& ids) {
  return std::all_of(ids.begin(), ids.end(), [&](const std::string& id) {
    return text.object(id) && text.object(id)->mount == Mount::surface;
  });
}

// "the speakers on either side of the TV", "the plants in the corners, one in each"
std::optional<ReadClause> read_shared_out(const EditText& text, const Read<Ids>& what) {
  if (what.value.size() < 2) return std::nullopt;
  const auto shared = shared_places_at(text, what.end, are_small(text, what.value));
  if (!shared) return std::nullopt;
  if (!*shared) return shared->error();
  const auto& places = (*shared)->value.places;
  if (what.value.size() > places.size())
    return not_understood(std::to_string(what.value.size()) + " things cannot be shared out among " +
                          std::to_string(places.size()) + " places");
  if (what.value.size() < places.size() && !(*shared)->value.places.front().front().target.empty())
    return not_understood("there are " + std::to_string(places.size()) + " places for " +
                          std::to_string(what.value.size()) + " things");
  Clause clause{{}, what.value, {}, (*shared)->end};
  for (std::size_t i = 0; i < what.value.size(); ++i) clause.operations.push_back(edit::Move{what.value[i], places[i]});
  return clause;
}

// "at the far end of the table", of several: side by side along it.
ReadClause put_in_row(const EditText& text, const Ids& ids, const Whereabouts& place) {
  const Object* host = text.object(place.spot->on);
  if (!host) return not_understood("it is not clear where each of them shall stand");
  const Footprint area = footprint(*host);
  const Vec2 off = place.spot->position - Vec2(host->position.head<2>());
  const bool is_at_side =
      std::abs(off.dot(area.x_axis())) / area.half().x() > std::abs(off.dot(area.y_axis())) / area.half().y();
  const Vec2 along = is_at_side ? area.y_axis() : area.x_axis();
  double pitch = 0.0;
  for (const auto& id : ids) pitch = std::max(pitch, text.object(id)->size.head<2>().maxCoeff() + row_gap);
  Clause clause{{}, ids, {}, place.end};
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const double aside = (static_cast<double>(i) - 0.5 * static_cast<double>(ids.size() - 1)) * pitch;
    clause.operations.push_back(edit::Put{ids[i], place.spot->position + aside * along, {}, place.spot->on});
  }
  return clause;
}

// "where the lamp is now"
ReadClause put_at_spot(const EditText& text, const Ids& ids, const Whereabouts& place) {
  if (ids.size() > 1 && !place.spot->is_place) return put_in_row(text, ids, place);
  if (ids.size() != 1)
    return not_understood("only one thing can stand at that place, and " + std::to_string(ids.size()) + " are meant");
  const Object* object = text.object(ids.front());
  const Object* there = text.object(place.spot->of);
  if (place.spot->is_place && object && there && object->mount != there->mount)
    return not_understood(object->id + " is not put up as " + there->id + " is");
  Clause clause{{edit::Put{ids.front(), place.spot->position, {}, place.spot->on}}, ids, {}, place.end};
  if (place.spot->is_place) clause.in_place_of = place.spot->of;
  return clause;
}

std::optional<ReadClause> read_lengthwise(const EditText& text, const Read<Ids>& what, bool is_group) {
  const auto shifting = shifting_at(text, what.end, what.value);
  if (!shifting) return std::nullopt;
  if (!*shifting) return shifting->error();
  if (!text.ends((*shifting)->end) && longest_in(text.edits.closers, text.tokens, (*shifting)->end) == 0)
    return std::nullopt;
  return read_shift(text, what.value, **shifting, is_group);
}

// "from the sofa", before where to
std::size_t behind_origin(const EditText& text, std::size_t at) {
  if (!text.is_word(at, "from") && !text.is_word(at, "off")) return at;
  const auto origin = target_at(text, at + 1, {});
  return origin && *origin && !text.ends((*origin)->end) ? (*origin)->end : at;
}

ReadClause read_to_place(const EditText& text, Read<Ids> what, bool is_group) {
  what.end = behind_origin(text, what.end);
  const auto place = destination_at(text, what.end, what.value);
  if (!place) return what_at(text, what.end, "it is not clear where to");
  if (!*place) return place->error();
  if ((*place)->spot) return put_at_spot(text, what.value, **place);
  auto clause = of_each(what, (*place)->end, [&](const std::string& id) {
    return edit::Move{id, (*place)->relations, is_group, (*place)->room};
  });
  clause->end = read_facing(text, clause->end, *clause);
  if (const auto along = along_behind(text, clause->end); along > 0) {
    for (auto& operation : clause->operations)
      if (auto* move = std::get_if<edit::Move>(&operation)) move->group = true;
    clause->end += along;
  }
  return clause;
}

}  // namespace

namespace {

// "under the table": in the middle below it; by itself in the middle of the room.
ReadClause read_centred(const EditText& text, const Read<Ids>& what) {
  std::size_t end = what.end;
  if (text.is_word(end, "in") && text.is_word(end + 1, "the") && text.is_word(end + 2, "room")) end += 3;
  std::vector<Relation> relations = {{RelationKind::middle, ""}, {RelationKind::in_part, "middle-third"}};
  if (const auto place = destination_at(text, end, what.value); place && *place && !(*place)->spot) {
    relations = (*place)->relations;
    const std::string target = relations.empty() ? "" : relations.front().target;
    const bool is_below = !relations.empty() && (relations.front().kind == RelationKind::above ||
                                                 relations.front().kind == RelationKind::under);
    if (find_object(text.scene, target) && !is_below) relations.push_back({RelationKind::center_aligned, target});
    end = (*place)->end;
  }
  return of_each(what, end, [&](const std::string& id) { return edit::Move{id, relations}; });
}

}  // namespace

ReadClause put_there(const EditText& text, Read<Ids> what) {
  for (const auto* gone : {&text.edits.goes_away, &text.edits.unneeded})
    if (const auto length = longest_in(*gone, text.tokens, what.end);
        length > 0 && goes_to_its_end(text, Clause{{}, {}, {}, what.end + length}))
      return Clause{{edit::Remove{what.value, false}}, {}, {}, what.end + length, what.value};
  const bool is_group = takes_group_along(text, what);
  if (auto mutual = read_mutual(text, what)) return *mutual;
  what.end = behind_modals(text, what.end);
  if (const auto length = longest_in(text.edits.refused, text.tokens, what.end);
      length > 0 && text.ends(what.end + length))
    return what_at(text, what.end, "that names no place");
  if (const auto centred = longest_in(text.edits.centred, text.tokens, what.end); centred > 0)
    if (auto there = read_centred(text, {what.value, what.end + centred}); goes_to_its_end(text, there)) return there;
  const std::size_t along = what.end + (text.is_word(what.end, "along") ? 1 : 0);
  if (const auto gap = gap_at(text, along, what.value)) return *gap ? keep_gap(text, **gap) : ReadClause(gap->error());
  for (const auto& read : {read_mutual, read_facing_away, read_shared_out})
    if (auto clause = read(text, what)) return *clause;
  if (longest_in(text.edits.faces, text.tokens, what.end) > 0) {
    Clause facing{{}, what.value, {}, what.end};
    facing.end = read_facing(text, what.end, facing);
    if (facing.end > what.end) return facing;
  }
  if (auto shifted = read_lengthwise(text, what, is_group)) return *shifted;
  return read_to_place(text, what, is_group);
}

namespace {

// "put one candlestick at either end of the table", where there are two.
std::optional<ReadClause> read_one_to_each(const EditText& text, std::size_t at) {
  const auto thing = named_thing_at(text, at);
  if (!text.is_word(at, "one") || !thing || !thing->kind.category || thing->further) return std::nullopt;
  const Ids there = fitting(text, *thing);
  const auto shared = shared_places_at(text, thing->end, are_small(text, there));
  if (!shared || !*shared || there.size() != (*shared)->value.places.size()) return std::nullopt;
  return read_shared_out(text, {there, thing->end});
}

}  // namespace

ReadClause read_put(const EditText& text, std::size_t at, bool may_add) {
  const auto thing = named_thing_at(text, at);
  // "put it back": what went may be there no more.
  if (thing && thing->which == NamedThing::Which::pronoun)
    if (const auto length = longest_in(text.edits.back, text.tokens, thing->end);
        length > 0 && text.is_word(thing->end, "back") && text.ends(thing->end + length))
      return Clause{{edit::Revert{}}, {}, {}, thing->end + length};
  if (may_add)
    if (auto shared = read_one_to_each(text, at)) return *shared;
  if (may_add && brings_something(text, at)) return read_add(text, at);
  const auto plain = things(text, at, false);
  if (may_add && !plain && !thing)
    if (auto added = read_add(text, at); goes_to_its_end(text, added)) return added;
  ReadClause first = plain ? put_there(text, *plain) : ReadClause(plain.error());
  if (goes_to_its_end(text, first)) return first;
  const auto placed = things(text, at, true);
  if (placed && (!plain || placed->end != plain->end)) {
    if (auto second = put_there(text, *placed); goes_to_its_end(text, second)) return second;
  }
  return first;
}

ReadClause read_lift(const EditText& text, std::size_t at, double way) {
  ReadClause failed = what_at(text, at, "it is not clear how far");
  for (const bool with_places : {true, false}) {
    const auto what = things(text, at, with_places);
    if (!what) {
      failed = what.error();
      continue;
    }
    std::size_t end = what->end;
    const auto metres = amount_at(text, end);
    if (!metres && !text.ends(end)) continue;
    return of_each(*what, end, [&](const std::string& id) {
      return edit::Shift{id, Vec3(0.0, 0.0, way * metres.value_or(usual_lift))};
    });
  }
  return failed;
}

ReadClause read_centre(const EditText& text, std::size_t at) {
  const auto what = things(text, at, false);
  return what ? read_centred(text, *what) : ReadClause(what.error());
}

}  // namespace roomgen
