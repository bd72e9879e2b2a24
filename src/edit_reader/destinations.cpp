#include "destinations.h"

#include <algorithm>

#include "clause_parts.h"
#include "room_names.h"
#include "roomgen/base/text.h"
#include "edit/walls.h"

namespace roomgen {

namespace {

using brief::Place;
using brief::PlacePhrase;

constexpr std::size_t most_places = 3;  // said of one thing
constexpr int deepest = 2;              // "the lamp on the desk by the window"

// The one window or door that is meant.
Result<std::string> opening_meant(const EditText& text, const PlacePhrase& place) {
  const std::string what = place.place == Place::window ? "window" : "door";
  const auto ids = openings_at_place(text, place);
  if (ids.size() == 1) return ids.front();
  if (ids.empty()) return not_understood("the room has no such " + what);
  return not_understood("the room has " + join(ids, " and ") + "; say which " + what + " by its id or its side");
}

// What relations to a part of the room say.
Result<std::vector<Relation>> relations_to_place(const EditText& text, const PlacePhrase& place,
                                                 const std::vector<RelationKind>& said) {
  std::vector<Relation> relations;
  switch (place.place) {
    case Place::window:
    case Place::door: {
      const auto id = opening_meant(text, place);
      if (!id) return id.error();
      for (const auto kind : said) relations.push_back({kind, *id});
      return relations;
    }
    case Place::corner:
      relations.push_back({RelationKind::corner, ""});
      if (!place.region.empty()) relations.push_back({RelationKind::in_part, place.region});
      return relations;
    case Place::wall: {
      relations.push_back({RelationKind::edge, ""});
      if (place.opposite) return not_understood("it is not clear which wall is opposite");
      if (place.wall < 0) return relations;
      const auto wall = wall_to(text.room(), place.wall);
      if (!wall) return not_understood("the room has no wall on that side");
      relations.push_back({RelationKind::next_to, wall_name(*wall)});
      return relations;
    }
    case Place::middle:
      return std::vector<Relation>{{RelationKind::middle, ""}, {RelationKind::in_part, "middle-third"}};
    case Place::region:
      return std::vector<Relation>{{RelationKind::in_part, place.region}};
    default:
      return not_understood("that names no place in the room");
  }
}

// Of "the filing cabinets" all are what something shall be near to, or far from.
std::vector<RelationKind> relation_to_several(const std::vector<RelationKind>& said) {
  const auto is = [&](RelationKind kind) { return std::find(said.begin(), said.end(), kind) != said.end(); };
  if (is(RelationKind::far)) return {RelationKind::far};
  if (is(RelationKind::near) || is(RelationKind::next_to)) return {RelationKind::near};
  return {};
}

Result<Read<std::vector<Relation>>> relations_to_things(const EditText& text, const NamedThing& thing,
                                                  const brief::Placement& placement,
                                                  const std::vector<std::string>& subjects) {
  const auto targets = targets_of(text, thing, subjects);
  if (!targets) return targets.error();
  const bool between = placement.relations == std::vector<RelationKind>{RelationKind::between};
  const auto kinds =
      targets->value.size() > 1 && !between ? relation_to_several(placement.relations) : placement.relations;
  if (kinds.empty() || (between && targets->value.size() != 2))
    return not_understood("\"" + text.words_from(thing.begin, targets->end) + "\" is " + join(targets->value, ", ") +
                          "; say which one");
  Read<std::vector<Relation>> relations{{}, targets->end};
  for (const auto& target : targets->value) {
    if (std::count(subjects.begin(), subjects.end(), target)) return not_understood(target + " cannot stand to itself");
    for (const auto kind : kinds) relations.value.push_back({kind, target});
  }
  return relations;
}

// "between the two windows"
std::optional<Result<Whereabouts>> between_openings(const EditText& text, const PlacePhrase& place, std::size_t end) {
  if (place.place != Place::window && place.place != Place::door) return std::nullopt;
  Whereabouts both{{}, {}, end};
  for (const auto& opening : text.room().openings)
    if ((opening.type == OpeningType::window) == (place.place == Place::window))
      both.relations.push_back({RelationKind::between, opening.id});
  if (both.relations.size() != 2) return std::nullopt;
  return both;
}

// "the wall opposite the bed", "the opposite wall": of the one that what goes there stands at now.
std::optional<Result<Whereabouts>> told_wall(const EditText& text, const PlacePhrase& place, std::size_t at,
                                             std::size_t end, const std::vector<std::string>& subjects) {
  if (place.place != Place::wall || place.wall >= 0) return std::nullopt;
  const auto at_wall = [](std::size_t wall, std::size_t behind) {
    return Whereabouts{{{RelationKind::edge, ""}, {RelationKind::next_to, wall_name(wall)}}, {}, behind};
  };
  if (const auto told = wall_by_target(text, end, false)) return at_wall(told->wall, told->end);
  for (std::size_t i = at; i < end; ++i) {
    const bool is_other = text.is_word(i, "other");
    const Object* subject = subjects.size() == 1 ? text.object(subjects.front()) : nullptr;
    if (is_other || (place.opposite && !subject))
      return not_understood("it is not clear which wall is meant; say which side, or what is there");
    if (place.opposite)
      return at_wall(wall_opposite(room_of(text.scene, *subject),
                                   *wall_named(room_of(text.scene, *subject), nearest_wall(text, *subject))),
                     end);
  }
  return std::nullopt;
}

// "between the bed and the sofa"
std::optional<Result<Whereabouts>> between_two(const EditText& text, std::size_t at,
                                               const brief::Placement& placement,
                                               const std::vector<std::string>& subjects) {
  if (placement.relations != std::vector<RelationKind>{RelationKind::between}) return std::nullopt;
  const auto first = target_at(text, at, subjects);
  if (!first || !*first || !text.is_word((*first)->end, "and")) return std::nullopt;
  const auto second = target_at(text, (*first)->end + 1, subjects);
  if (!second) return std::nullopt;
  if (!*second) return second->error();
  return Whereabouts{
      {{RelationKind::between, (*first)->id}, {RelationKind::between, (*second)->id}}, {}, (*second)->end};
}

// "window-0" comes as two tokens.
std::optional<Target> opening_by_id(const EditText& text, std::size_t at) {
  while (at < text.tokens.size() && text.words.definite.count(text.tokens[at].text)) ++at;
  if (at + 1 >= text.raw.size() || text.raw[at + 1].kind != language::Token::Kind::number ||
      text.raw[at + 1].joint != language::Token::Joint::hyphen)
    return std::nullopt;
  const std::string id = text.tokens[at].text + "-" + text.raw[at + 1].text;
  if (!find_opening(text.room(), id)) return std::nullopt;
  return Target{id, at + 2};
}

// The place that `length` tokens say, and what it is relative to.
std::optional<Result<Whereabouts>> place_by(const EditText& text, std::size_t at, std::size_t length,
                                            const std::vector<std::string>& subjects) {
  const std::string phrase = text.words_from(at, at + length);
  const auto other = text.edits.places.find(phrase);
  const auto said = text.words.placements.find(other == text.edits.places.end() ? phrase : other->second);
  if (said == text.words.placements.end()) return std::nullopt;
  const brief::Placement& placement = said->second;
  if (placement.pronoun || placement.inverse || placement.mutual || placement.relations.empty()) return std::nullopt;
  const std::size_t target = at + length;
  if (auto both = between_two(text, target, placement, subjects)) return both;
  if (const auto opening = opening_by_id(text, target)) {
    Whereabouts there{{}, {}, opening->end};
    for (const auto kind : placement.relations) there.relations.push_back({kind, opening->id});
    return there;
  }
  const auto thing = named_thing_at(text, target);
  const auto place = place_named_at(text, target);
  if (place && (!thing || target + place->length >= thing->end)) {
    const bool between = placement.relations == std::vector<RelationKind>{RelationKind::between};
    if (auto both = between ? between_openings(text, *place, target + place->length) : std::nullopt) return both;
    if (auto wall = told_wall(text, *place, target, target + place->length, subjects)) return wall;
    auto relations = relations_to_place(text, *place, placement.relations);
    if (!relations) return relations.error();
    return Whereabouts{*std::move(relations), {}, target + place->length};
  }
  if (!thing) return std::nullopt;
  auto relations = relations_to_things(text, *thing, placement, subjects);
  if (!relations) return relations.error();
  return Whereabouts{std::move(relations->value), {}, text.end_of_most(relations->end)};
}

// "on the left nightstand" begins with "on the left", but means no more than "on".
std::optional<Result<Whereabouts>> plain_place_at(const EditText& text, std::size_t at,
                                                  const std::vector<std::string>& subjects) {
  const auto most = std::max(longest(text.words.placements, text.tokens, at).length,
                             longest(text.edits.places, text.tokens, at).length);
  for (std::size_t length = most; length > 0; --length)
    if (auto place = place_by(text, at, length, subjects)) return place;
  return std::nullopt;
}

// "right next to", "back against": words may stand before a place that say nothing more.
std::optional<Result<Whereabouts>> one_place_at(const EditText& text, std::size_t at,
                                                const std::vector<std::string>& subjects) {
  for (;;) {
    if (auto place = plain_place_at(text, at, subjects)) return place;
    const auto length = longest_in(text.edits.emphasis, text.tokens, at);
    if (length == 0) return std::nullopt;
    at += length;
  }
}

}  // namespace

std::optional<std::size_t> wall_to(const Room& room, int side) {
  const Vec2 outward[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < room.polygon.size(); ++k)
    if (-room.polygon.inward(k).dot(outward[side]) > 0.9 &&
        (!best || room.polygon.edge(k).length() > room.polygon.edge(*best).length()))
      best = k;
  return best;
}

std::vector<std::string> openings_at_place(const EditText& text, const PlacePhrase& place) {
  const Room& room = text.room();
  std::vector<std::string> ids;
  const auto wall = place.wall >= 0 ? wall_to(room, place.wall) : std::nullopt;
  for (const auto& opening : room.openings)
    if ((opening.type == OpeningType::window) == (place.place == Place::window) && (!wall || opening.wall == *wall))
      ids.push_back(opening.id);
  return ids;
}

std::optional<Read<std::vector<RelationKind>>> placed_by(const EditText& text, std::size_t at) {
  const auto plain = longest(text.words.placements, text.tokens, at);
  const auto other = longest(text.edits.places, text.tokens, at);
  const auto said = other.length > plain.length ? text.words.placements.find(*other.value)
                    : plain                     ? text.words.placements.find(text.words_from(at, at + plain.length))
                                                : text.words.placements.end();
  if (said == text.words.placements.end() || said->second.pronoun || said->second.inverse || said->second.mutual)
    return std::nullopt;
  return Read<std::vector<RelationKind>>{said->second.relations, at + std::max(plain.length, other.length)};
}

std::string nearest_wall(const EditText& text, const Object& object) {
  const Polygon& walls = room_of(text.scene, object).polygon;
  std::size_t nearest = 0;
  const auto away = [&](std::size_t k) { return distance(walls.edge(k), Vec2(object.position.head<2>())); };
  for (std::size_t k = 1; k < walls.size(); ++k)
    if (away(k) < away(nearest)) nearest = k;
  return wall_name(nearest);
}

std::optional<brief::PlacePhrase> place_named_at(const EditText& text, std::size_t at) {
  const auto place = brief::read_place({text.tokens.data(), text.tokens.size()}, at, text.words);
  const auto thing = named_thing_at(text, at);
  const bool is_behind_thing =
      place && thing && thing->kind.category && thing->end + 1 < at + place->length && !fitting(text, *thing).empty();
  return is_behind_thing ? std::nullopt : place;
}

std::optional<Result<Target>> target_at(const EditText& text, std::size_t at,
                                        const std::vector<std::string>& subjects) {
  if (const auto opening = opening_by_id(text, at)) return *opening;
  const auto thing = named_thing_at(text, at);
  const auto place = place_named_at(text, at);
  if (place && (!thing || at + place->length >= thing->end)) {
    const std::size_t end = at + place->length;
    if (place->place == Place::window || place->place == Place::door) {
      const auto id = opening_meant(text, *place);
      if (!id) return id.error();
      return Target{*id, end};
    }
    if (place->place == Place::wall && place->wall >= 0)
      if (const auto wall = wall_to(text.room(), place->wall))
        return Target{wall_name(*wall), end};
    return not_understood("\"" + text.words_from(at, end) + "\": say which one");
  }
  if (!thing) return std::nullopt;
  const auto ids = targets_of(text, *thing, subjects);
  if (!ids) return ids.error();
  if (ids->value.size() != 1)
    return not_understood("\"" + text.words_from(at, ids->end) + "\" is " + join(ids->value, ", ") + "; say which one");
  return Target{ids->value.front(), ids->end};
}

Result<Read<std::vector<std::string>>> targets_of(const EditText& text, const NamedThing& thing,
                                                  const std::vector<std::string>& subjects) {
  auto all = fitting(text, thing);
  std::erase_if(all, [&](const std::string& id) { return std::count(subjects.begin(), subjects.end(), id) > 0; });
  const auto plain = meant(text, thing, thing.which == NamedThing::Which::pronoun ? nullptr : &all);
  if (plain)
    return Read<std::vector<std::string>>{*plain,
                                          thing.end + longest_in(text.edits.just_added, text.tokens, thing.end)};
  if (thing.which == NamedThing::Which::pronoun || text.depth >= deepest) return plain.error();
  EditText deeper = text;
  ++deeper.depth;
  const auto told = told_by_tail(deeper, thing);
  if (!told || !*told) return plain.error();
  return **told;
}

std::optional<Result<Whereabouts>> destination_at(const EditText& text, std::size_t at,
                                                  const std::vector<std::string>& subjects) {
  Whereabouts all;
  for (std::size_t n = 0; n < most_places; ++n) {
    if (n == 0)
      if (const auto room = in_room_at(text, at)) {
        if (!*room) return room->error();
        return Whereabouts{{}, {}, (*room)->end, (*room)->value};
      }
    if (n == 0)
      if (auto spot = spot_at(text, at, subjects)) return spot;
    const auto one = one_place_at(text, at, subjects);
    if (!one) break;
    if (!*one) return one->error();
    for (const auto& relation : (*one)->relations)
      if (std::find(all.relations.begin(), all.relations.end(), relation) == all.relations.end())
        all.relations.push_back(relation);
    at = all.end = (*one)->end;
  }
  if (all.relations.empty()) return std::nullopt;
  return all;
}

}  // namespace roomgen
