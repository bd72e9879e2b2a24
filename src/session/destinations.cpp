#include "destinations.h"

#include <algorithm>
#include <cmath>

#include "brief/placement_phrase.h"
#include "language/measure.h"
#include "room_names.h"
#include "roomgen/base/text.h"
#include "walls.h"
#include "spots.h"

namespace roomgen {

namespace {

using design::Place;
using design::PlacePhrase;

constexpr std::size_t most_places = 3;  // said of one thing

// The one window or door that is meant.
Result<std::string> opening_meant(const EditText& text, const PlacePhrase& place) {
  const Room& room = text.room();
  const std::string what = place.place == Place::window ? "window" : "door";
  std::vector<std::string> ids;
  const auto wall = place.wall >= 0 ? wall_to(room, place.wall) : std::nullopt;
  for (const auto& opening : room.openings)
    if ((opening.type == OpeningType::window) == (place.place == Place::window) && (!wall || opening.wall == *wall))
      ids.push_back(opening.id);
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

Result<std::vector<Relation>> relations_to_things(const EditText& text, const NamedThing& thing,
                                                  const design::Placement& placement,
                                                  const std::vector<std::string>& subjects) {
  auto all = fitting(text, thing);
  std::erase_if(all, [&](const std::string& id) { return std::count(subjects.begin(), subjects.end(), id) > 0; });
  const auto targets = meant(text, thing, thing.which == NamedThing::Which::pronoun ? nullptr : &all);
  if (!targets) return targets.error();
  const bool between = placement.relations == std::vector<RelationKind>{RelationKind::between};
  if (targets->size() != (between ? 2u : 1u))
    return not_understood("\"" + text.words_from(thing.begin, thing.end) + "\" is " + join(*targets, ", ") +
                          "; say which one");
  std::vector<Relation> relations;
  for (const auto& target : *targets) {
    if (std::count(subjects.begin(), subjects.end(), target)) return not_understood(target + " cannot stand to itself");
    for (const auto kind : placement.relations) relations.push_back({kind, target});
  }
  return relations;
}

// "between the bed and the sofa"
std::optional<Result<Whereabouts>> between_two(const EditText& text, std::size_t at, const design::Placement& placement,
                                               const std::vector<std::string>& subjects) {
  if (placement.relations != std::vector<RelationKind>{RelationKind::between}) return std::nullopt;
  const auto first = target_at(text, at, subjects);
  if (!first || !*first || !text.is_word((*first)->end, "and")) return std::nullopt;
  const auto second = target_at(text, (*first)->end + 1, subjects);
  if (!second) return std::nullopt;
  if (!*second) return second->error();
  return Whereabouts{{{RelationKind::between, (*first)->id}, {RelationKind::between, (*second)->id}}, {}, (*second)->end};
}

// The place that `length` tokens say, and what it is relative to.
std::optional<Result<Whereabouts>> place_by(const EditText& text, std::size_t at, std::size_t length,
                                            const std::vector<std::string>& subjects) {
  const std::string phrase = text.words_from(at, at + length);
  const auto other = text.edits.places.find(phrase);
  const auto said = text.words.placements.find(other == text.edits.places.end() ? phrase : other->second);
  if (said == text.words.placements.end()) return std::nullopt;
  const design::Placement& placement = said->second;
  if (placement.pronoun || placement.inverse || placement.mutual || placement.relations.empty()) return std::nullopt;
  const std::size_t target = at + length;
  if (auto both = between_two(text, target, placement, subjects)) return both;
  const auto thing = named_thing_at(text, target);
  const auto place = design::read_place({text.tokens.data(), text.tokens.size()}, target, text.words);
  if (place && (!thing || target + place->length >= thing->end)) {
    auto relations = relations_to_place(text, *place, placement.relations);
    if (!relations) return relations.error();
    return Whereabouts{*std::move(relations), {}, target + place->length};
  }
  if (!thing) return std::nullopt;
  auto relations = relations_to_things(text, *thing, placement, subjects);
  if (!relations) return relations.error();
  return Whereabouts{*std::move(relations), {}, text.end_of_most(thing->end)};
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

std::optional<double> amount_at(const EditText& text, std::size_t& at) {
  std::size_t from = at;
  if (text.is_word(from, "by") || text.is_word(from, "about") || text.is_word(from, "maybe")) ++from;
  if (const auto measure = language::measure_at(text.raw, from);
      measure && measure->kind == language::Measure::Kind::length && measure->has_unit) {
    at = from + measure->length;
    return measure->values[0];
  }
  if (const auto vague = longest(text.edits.amounts, text.tokens, from)) {
    at = from + vague.length;
    return *vague.value;
  }
  return std::nullopt;
}

std::optional<std::size_t> wall_to(const Room& room, int side) {
  const Vec2 outward[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < room.polygon.size(); ++k)
    if (-room.polygon.inward(k).dot(outward[side]) > 0.9 &&
        (!best || room.polygon.edge(k).length() > room.polygon.edge(*best).length()))
      best = k;
  return best;
}

std::string nearest_wall(const EditText& text, const Object& object) {
  const Polygon& walls = room_of(text.scene, object).polygon;
  std::size_t nearest = 0;
  const auto away = [&](std::size_t k) { return distance(walls.edge(k), Vec2(object.position.head<2>())); };
  for (std::size_t k = 1; k < walls.size(); ++k)
    if (away(k) < away(nearest)) nearest = k;
  return wall_name(nearest);
}

namespace {

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

}  // namespace

std::optional<Result<Target>> target_at(const EditText& text, std::size_t at,
                                        const std::vector<std::string>& subjects) {
  if (const auto opening = opening_by_id(text, at)) return *opening;
  const auto thing = named_thing_at(text, at);
  const auto place = design::read_place({text.tokens.data(), text.tokens.size()}, at, text.words);
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
  auto all = fitting(text, *thing);
  std::erase_if(all, [&](const std::string& id) { return std::count(subjects.begin(), subjects.end(), id) > 0; });
  const auto ids = meant(text, *thing, thing->which == NamedThing::Which::pronoun ? nullptr : &all);
  if (!ids) return ids.error();
  if (ids->size() != 1) return not_understood("\"" + text.words_from(at, thing->end) + "\" is " + join(*ids, ", ") + "; say which one");
  return Target{ids->front(), thing->end};
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

std::optional<Result<Shifting>> shifting_at(const EditText& text, std::size_t at,
                                            const std::vector<std::string>& subjects) {
  Shifting shifting;
  if (text.is_word(at, "out") || text.is_word(at, "over")) ++at;
  shifting.metres = amount_at(text, at);
  const auto target_behind = [&](std::size_t length) { return target_at(text, at + length, subjects); };
  const std::size_t away = longest_in(text.edits.away, text.tokens, at);
  const std::size_t closer = longest_in(text.edits.closer, text.tokens, at);
  if (const auto height = longest(text.edits.heights, text.tokens, at); height && shifting.metres) {
    shifting.direction = Vec3(0, 0, *height.value);
    at += height.length;
  } else if (const auto direction = longest(text.edits.directions, text.tokens, at); direction && direction.length >= std::max(away, closer)) {
    // "to the left of the bed" is a place.
    if (text.is_word(at + direction.length, "of")) return std::nullopt;
    shifting.direction = Vec3(direction.value->x(), direction.value->y(), 0.0);
    at += direction.length;
  } else if (away > 0 || closer > 0) {
    const auto target = target_behind(std::max(away, closer));
    if (!target) return std::nullopt;
    if (!*target) return target->error();
    (away >= closer && away > 0 ? shifting.from : shifting.towards) = (*target)->id;
    at = (*target)->end;
  } else {
    return std::nullopt;
  }
  if (!shifting.metres) shifting.metres = amount_at(text, at);
  shifting.end = at;
  return shifting;
}

}  // namespace roomgen
