#include "clause.h"

#include <algorithm>
#include <cmath>

#include "brief/placement_phrase.h"
#include "gaps.h"
#include "new_things.h"
#include "operations.h"
#include "sharing.h"
#include "walls.h"

namespace roomgen {

namespace {

constexpr double usual_shift = 0.5;  // metres, where nobody says how far
constexpr double usual_lift = 0.2;

Vec2 middle_of(const EditText& text, const Object& object, const std::string& target) {
  if (const Object* other = find_object(text.scene, target)) return other->position.head<2>();
  const Room& room = room_of(text.scene, object);
  if (const Opening* opening = find_opening(room, target)) return segment(room, *opening).middle();
  if (const auto wall = wall_named(room, target)) return closest_point(room.polygon.edge(*wall), object.position.head<2>());
  return object.position.head<2>();
}

ReadClause read_shift(const EditText& text, const Ids& ids, const Shifting& how, bool group) {
  Clause clause;
  clause.about = ids;
  clause.end = how.end;
  for (const auto& id : ids) {
    const Object* object = find_object(text.scene, id);
    if (!object) return not_understood(id + " has no place yet from which it could move");
    if (!how.metres && !how.direction) {
      const RelationKind kind = how.from ? RelationKind::far : RelationKind::near;
      clause.operations.push_back(edit::Move{id, {{kind, how.from ? *how.from : *how.towards}}, group});
      continue;
    }
    Vec3 direction = how.direction.value_or(Vec3::Zero());
    if (!how.direction) {
      direction.head<2>() = middle_of(text, *object, how.from ? *how.from : *how.towards) - Vec2(object->position.head<2>());
      if (direction.norm() < 1e-6) return not_understood("it is not clear which way " + id + " shall move");
      direction = direction.normalized() * (how.from ? -1.0 : 1.0);
    }
    clause.operations.push_back(edit::Shift{id, direction * how.metres.value_or(usual_shift), group});
  }
  return clause;
}

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

// "to face each other", "side by side against the wall"
std::optional<ReadClause> read_mutual(const EditText& text, const Read<Ids>& what) {
  if (what.value.size() < 2) return std::nullopt;
  const auto faces = longest_in(text.edits.faces, text.tokens, what.end);
  if (faces > 0 && longest_in(text.edits.each_other, text.tokens, what.end + faces) > 0) {
    if (what.value.size() != 2) return not_understood("only two things can face each other, and " + std::to_string(what.value.size()) + " are meant");
    const std::size_t end = what.end + faces + longest_in(text.edits.each_other, text.tokens, what.end + faces);
    return Clause{{edit::Face{what.value[0], what.value[1]}, edit::Face{what.value[1], what.value[0]}}, what.value, {}, end};
  }
  const std::size_t bit = longest(text.edits.amounts, text.tokens, what.end).length;
  auto length = longest_in(text.edits.side_by_side, text.tokens, what.end + bit);
  if (length == 0) return std::nullopt;
  length += bit;
  const auto place = destination_at(text, what.end + length, what.value);
  if (place && !*place) return place->error();
  Clause clause{{}, what.value, {}, place ? (*place)->end : what.end + length};
  for (std::size_t i = 0; i < what.value.size(); ++i) {
    std::vector<Relation> relations = place ? (*place)->relations : std::vector<Relation>();
    if (i > 0) relations.insert(relations.begin(), {RelationKind::next_to, what.value[i - 1]});
    if (!relations.empty()) clause.operations.push_back(edit::Move{what.value[i], relations});
  }
  return clause;
}

bool are_small(const EditText& text, const Ids& ids) {
  return std::all_of(ids.begin(), ids.end(), [&](const std::string& id) { return text.object(id) && text.object(id)->mount == Mount::surface; });
}

// "the speakers on either side of the TV", "the plants in the corners, one in each"
std::optional<ReadClause> read_shared_out(const EditText& text, const Read<Ids>& what) {
  if (what.value.size() < 2) return std::nullopt;
  const auto shared = shared_places_at(text, what.end, are_small(text, what.value));
  if (!shared) return std::nullopt;
  if (!*shared) return shared->error();
  const auto& places = (*shared)->value.places;
  if (what.value.size() > places.size())
    return not_understood(std::to_string(what.value.size()) + " things cannot be shared out among " + std::to_string(places.size()) + " places");
  if (what.value.size() < places.size() && !(*shared)->value.places.front().front().target.empty())
    return not_understood("there are " + std::to_string(places.size()) + " places for " + std::to_string(what.value.size()) + " things");
  Clause clause{{}, what.value, {}, (*shared)->end};
  for (std::size_t i = 0; i < what.value.size(); ++i) clause.operations.push_back(edit::Move{what.value[i], places[i]});
  return clause;
}

// "where the lamp is now"
ReadClause put_at_spot(const EditText& text, const Ids& ids, const Whereabouts& place) {
  if (ids.size() != 1) return not_understood("only one thing can stand at that place, and " + std::to_string(ids.size()) + " are meant");
  const Object* object = text.object(ids.front());
  const Object* there = text.object(place.spot->of);
  if (place.spot->is_place && object && there && object->mount != there->mount)
    return not_understood(object->id + " is not put up as " + there->id + " is");
  Clause clause{{edit::Put{ids.front(), place.spot->position, {}, place.spot->on}}, ids, {}, place.end};
  if (place.spot->is_place) clause.in_place_of = place.spot->of;
  return clause;
}

// "with its back to the bed": the front away from it.
std::optional<ReadClause> read_facing_away(const EditText& text, const Read<Ids>& what) {
  const auto length = longest_in(text.edits.facing_away, text.tokens, what.end);
  if (length == 0 || text.is_word(what.end, "away")) return std::nullopt;
  const auto target = target_at(text, what.end + length, what.value);
  if (!target || !*target) return std::nullopt;
  Clause clause{{}, what.value, {}, (*target)->end};
  for (const auto& id : what.value) {
    const Object* object = find_object(text.scene, id);
    if (!object) return not_understood(id + " has no place yet");
    const Vec2 away = Vec2(object->position.head<2>()) - middle_of(text, *object, (*target)->id);
    if (away.norm() < 1e-6) return not_understood("it is not clear which way " + id + " shall face");
    const double yaw = std::atan2(away.x(), -away.y());  // at 0 the front looks to -Y
    clause.operations.push_back(edit::Turn{id, std::remainder(yaw - object->yaw, 2.0 * pi)});
  }
  return clause;
}

std::optional<ReadClause> read_lengthwise(const EditText& text, const Read<Ids>& what, bool is_group) {
  const auto shifting = shifting_at(text, what.end, what.value);
  if (!shifting) return std::nullopt;
  if (!*shifting) return shifting->error();
  if (!text.ends((*shifting)->end) && longest_in(text.edits.closers, text.tokens, (*shifting)->end) == 0) return std::nullopt;
  return read_shift(text, what.value, **shifting, is_group);
}

ReadClause read_to_place(const EditText& text, const Read<Ids>& what, bool is_group) {
  const auto place = destination_at(text, what.end, what.value);
  if (!place) return what_at(text, what.end, "it is not clear where to");
  if (!*place) return place->error();
  if ((*place)->spot) return put_at_spot(text, what.value, **place);
  auto clause = of_each(what, (*place)->end,
                        [&](const std::string& id) { return edit::Move{id, (*place)->relations, is_group, (*place)->room}; });
  clause->end = read_facing(text, clause->end, *clause);
  if (const auto along = along_behind(text, clause->end); along > 0) {
    for (auto& operation : clause->operations)
      if (auto* move = std::get_if<edit::Move>(&operation)) move->group = true;
    clause->end += along;
  }
  return clause;
}

std::size_t skip_modals(const EditText& text, std::size_t at) {
  for (;;) {
    const auto modal = longest_in(text.edits.modals, text.tokens, at), auxiliary = longest_in(text.edits.auxiliaries, text.tokens, at);
    // "to the window" is no infinitive.
    const bool is_place = longest(text.edits.places, text.tokens, at) || longest(text.words.placements, text.tokens, at);
    if (std::max(modal, auxiliary) == 0 || (modal == 0 && (is_place || text.is_word(at, "to")))) return at;
    at += std::max(modal, auxiliary);
  }
}

ReadClause put_there(const EditText& text, Read<Ids> what) {
  for (const auto* gone : {&text.edits.goes_away, &text.edits.unneeded})
    if (const auto length = longest_in(*gone, text.tokens, what.end); length > 0 && goes_to_its_end(text, Clause{{}, {}, {}, what.end + length}))
      return Clause{{edit::Remove{what.value, false}}, {}, {}, what.end + length, what.value};
  const bool is_group = takes_group_along(text, what);
  if (auto mutual = read_mutual(text, what)) return *mutual;
  what.end = skip_modals(text, what.end);
  if (const auto length = longest_in(text.edits.refused, text.tokens, what.end); length > 0 && text.ends(what.end + length))
    return what_at(text, what.end, "that names no place");
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

ReadClause read_line(const EditText& text, std::size_t at) {
  const auto what = things(text, at, false);
  if (!what) return what.error();
  const auto target = text.is_word(what->end, "with") ? target_at(text, what->end + 1, what->value) : std::nullopt;
  if (target && *target)
    return of_each(*what, (*target)->end, [&](const std::string& id) {
      return edit::Move{id, {{RelationKind::aligned, (*target)->id}}};
    });
  const std::size_t up = what->end + (text.is_word(what->end, "up") ? 1 : 0);
  const auto place = destination_at(text, up, what->value);
  if (!place) return what_at(text, up, "it is not clear along what");
  if (!*place) return place->error();
  if ((*place)->spot) return what_at(text, up, "it is not clear along what");
  return of_each(*what, (*place)->end, [&](const std::string& id) { return edit::Move{id, (*place)->relations}; });
}

ReadClause read_centre(const EditText& text, std::size_t at) {
  const auto what = things(text, at, false);
  if (!what) return what.error();
  std::size_t end = what->end;
  if (text.is_word(end, "in") && text.is_word(end + 1, "the") && text.is_word(end + 2, "room")) end += 3;
  return of_each(*what, end, [](const std::string& id) {
    return edit::Move{id, {{RelationKind::middle, ""}, {RelationKind::in_part, "middle-third"}}};
  });
}

// ---- Turning -----------------------------------------------------------------------------------

namespace {

std::optional<Read<double>> turn_at(const EditText& text, std::size_t at) {
  if (text.is_word(at, "by")) ++at;
  if (const auto turn = longest(text.edits.turns, text.tokens, at)) {
    at += turn.length;
    const auto way = longest(text.edits.turn_directions, text.tokens, at);
    return Read<double>{(way ? *way.value : 1.0) * *turn.value, at + way.length};
  }
  double sign = 1.0;
  const auto before = longest(text.edits.turn_directions, text.tokens, at);
  if (before) sign = *before.value, at += before.length;
  if (text.is_word(at, "by")) ++at;
  if (at >= text.tokens.size() || text.tokens[at].kind != design::Token::Kind::number) return std::nullopt;
  const double degrees = text.tokens[at].value;
  if (!text.is_word(at + 1, "degrees") && !text.is_word(at + 1, "degree") && !text.is_word(at + 1, "deg")) return std::nullopt;
  at += 2;
  if (const auto behind = longest(text.edits.turn_directions, text.tokens, at))
    sign = *behind.value, at += behind.length;
  return Read<double>{sign * degrees, at};
}

// "a quarter turn together with its chairs" turns each where it stands: that is not meant.
ReadClause turned(const EditText& text, const Read<Ids>& what, const Read<double>& turn) {
  if (longest_in(text.edits.along, text.tokens, turn.end) > 0) return what_at(text, turn.end, "groups cannot be turned");
  return of_each(what, turn.end, [&](const std::string& id) { return edit::Turn{id, radians(turn.value)}; });
}

}  // namespace

// "a quarter turn to the left for the armchair"
ReadClause read_turn_first(const EditText& text, std::size_t at) {
  const auto turn = turn_at(text, at);
  if (!turn || (!text.is_word(turn->end, "for") && !text.is_word(turn->end, "of"))) return what_at(text, at, "not understood");
  const auto what = things(text, turn->end + 1, true);
  if (!what) return what.error();
  return of_each(*what, what->end, [&](const std::string& id) { return edit::Turn{id, radians(turn->value)}; });
}

ReadClause read_ellipsis(const EditText& text, std::size_t at) {
  if (text.latest.empty()) return what_at(text, at, "not understood");
  const Read<Ids> what{text.latest, at};
  if (const auto turn = turn_at(text, at))
    return of_each(what, turn->end, [&](const std::string& id) { return edit::Turn{id, radians(turn->value)}; });
  for (const auto& other : {read_size(text, what, at), recolored(text, what, at), put_there(text, what)})
    if (goes_to_its_end(text, other)) return other;
  return what_at(text, at, "not understood");
}

ReadClause read_turn(const EditText& text, std::size_t at) {
  ReadClause failed = what_at(text, at, "it is not clear which way to turn");
  for (const bool with_places : {false, true}) {
    const auto what = things(text, at, with_places);
    if (!what) {
      if (!with_places) failed = what.error();
      continue;
    }
    if (auto mutual = read_mutual(text, *what)) return *mutual;
    if (auto away = read_facing_away(text, *what)) return *away;
    std::size_t behind = what->end;
    const auto turn = turn_at(text, what->end);
    // "turn it round to face the piano"
    const bool says_towards = turn && longest_in(text.edits.faces, text.tokens, turn->end) > 0;
    if (says_towards) behind = turn->end;
    else if (turn) return turned(text, *what, *turn);
    auto length = longest_in(text.edits.faces, text.tokens, behind);
    if (length == 0) length = longest_in(text.edits.to, text.tokens, behind);
    if (length == 0) continue;
    length += behind - what->end;
    const auto place = design::read_place({text.tokens.data(), text.tokens.size()}, what->end + length, text.words);
    if (place && place->place == design::Place::wall && place->wall < 0 && !place->opposite)
      return of_each(*what, what->end + length + place->length, [&](const std::string& id) {
        return edit::Face{id, nearest_wall(text, *text.object(id))};
      });
    const auto target = target_at(text, what->end + length, what->value);
    if (!target) continue;
    if (*target)
      return of_each(*what, (*target)->end, [&](const std::string& id) { return edit::Face{id, (*target)->id}; });
    failed = target->error();
  }
  return failed;
}

}  // namespace roomgen
