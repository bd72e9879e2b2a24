#include <cmath>

#include "brief/placement_phrase.h"
#include "clause.h"
#include "edit/walls.h"

namespace roomgen {

namespace {

constexpr double usual_parting = 0.5;  // metres, where nobody says how far apart

}  // namespace

Vec2 middle_of_target(const EditText& text, const Object& object, const std::string& target) {
  if (const Object* other = find_object(text.scene, target)) return other->position.head<2>();
  const Room& room = room_of(text.scene, object);
  if (const Opening* opening = find_opening(room, target)) return segment(room, *opening).middle();
  if (const auto wall = wall_named(room, target))
    return closest_point(room.polygon.edge(*wall), object.position.head<2>());
  return object.position.head<2>();
}

namespace {

// "apart", "away from each other": each by half as much.
ReadClause read_apart(const EditText& text, const Read<Ids>& what, std::size_t end) {
  if (what.value.size() != 2)
    return not_understood("only two things can move apart, and " + std::to_string(what.value.size()) + " are meant");
  const Object* first = find_object(text.scene, what.value[0]);
  const Object* second = find_object(text.scene, what.value[1]);
  if (!first || !second) return not_understood("they have no places yet from which they could move");
  const double metres = amount_at(text, end).value_or(usual_parting);
  const Vec2 way = Vec2(second->position.head<2>()) - Vec2(first->position.head<2>());
  if (way.norm() < 1e-6) return not_understood("it is not clear which way they shall move");
  const Vec2 half = 0.5 * metres * way.normalized();
  return Clause{
      {edit::Shift{first->id, Vec3(-half.x(), -half.y(), 0.0)}, edit::Shift{second->id, Vec3(half.x(), half.y(), 0.0)}},
      what.value,
      {},
      end};
}

}  // namespace

std::optional<ReadClause> read_mutual(const EditText& text, const Read<Ids>& what) {
  if (what.value.size() < 2) return std::nullopt;
  const auto faces = longest_in(text.edits.faces, text.tokens, what.end);
  if (faces > 0 && longest_in(text.edits.each_other, text.tokens, what.end + faces) > 0) {
    if (what.value.size() != 2)
      return not_understood("only two things can face each other, and " + std::to_string(what.value.size()) +
                            " are meant");
    const std::size_t end = what.end + faces + longest_in(text.edits.each_other, text.tokens, what.end + faces);
    return Clause{
        {edit::Face{what.value[0], what.value[1]}, edit::Face{what.value[1], what.value[0]}}, what.value, {}, end};
  }
  const std::size_t bit = longest(text.edits.amounts, text.tokens, what.end).length;
  if (const auto apart = longest_in(text.edits.apart, text.tokens, what.end + bit); apart > 0)
    return read_apart(text, what, what.end + bit + apart);
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

std::optional<ReadClause> read_facing_away(const EditText& text, const Read<Ids>& what) {
  const auto length = longest_in(text.edits.facing_away, text.tokens, what.end);
  if (length == 0 || text.is_word(what.end, "away")) return std::nullopt;
  const auto place = place_named_at(text, what.end + length);
  const bool is_any_wall =
      place && place->place == brief::Place::wall && place->wall < 0 && !place->opposite;
  const auto target = is_any_wall ? std::nullopt : target_at(text, what.end + length, what.value);
  if (!is_any_wall && (!target || !*target)) return std::nullopt;
  Clause clause{{}, what.value, {}, is_any_wall ? what.end + length + place->length : (*target)->end};
  for (const auto& id : what.value) {
    const Object* object = find_object(text.scene, id);
    if (!object) return not_understood(id + " has no place yet");
    const Vec2 away = Vec2(object->position.head<2>()) -
                      middle_of_target(text, *object, is_any_wall ? nearest_wall(text, *object) : (*target)->id);
    if (away.norm() < 1e-6) return not_understood("it is not clear which way " + id + " shall face");
    const double yaw = std::atan2(away.x(), -away.y());  // at 0 the front looks to -Y
    clause.operations.push_back(edit::Turn{id, std::remainder(yaw - object->yaw, 2.0 * pi)});
  }
  return clause;
}

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
  if (at >= text.tokens.size() || text.tokens[at].kind != brief::Token::Kind::number)
    return std::nullopt;
  const double degrees = text.tokens[at].value;
  if (!text.is_word(at + 1, "degrees") && !text.is_word(at + 1, "degree") && !text.is_word(at + 1, "deg"))
    return std::nullopt;
  at += 2;
  if (const auto behind = longest(text.edits.turn_directions, text.tokens, at))
    sign = *behind.value, at += behind.length;
  return Read<double>{sign * degrees, at};
}

// "a quarter turn together with its chairs": what is said to come along may stand behind the thing or behind the angle.
ReadClause turned(const EditText& text, const Read<Ids>& what, const Read<double>& turn, bool is_group) {
  const auto along = longest_in(text.edits.along, text.tokens, turn.end);
  return of_each(what, turn.end + along, [&](const std::string& id) {
    return edit::Turn{id, radians(turn.value), is_group || along > 0};
  });
}

}  // namespace

// "a quarter turn to the left for the armchair"
ReadClause read_turn_first(const EditText& text, std::size_t at) {
  const auto turn = turn_at(text, at);
  if (!turn || (!text.is_word(turn->end, "for") && !text.is_word(turn->end, "of")))
    return what_at(text, at, "not understood");
  const auto what = things(text, turn->end + 1, true);
  if (!what) return what.error();
  return of_each(*what, what->end, [&](const std::string& id) { return edit::Turn{id, radians(turn->value)}; });
}

ReadClause read_ellipsis(const EditText& text, std::size_t at) {
  if (text.latest.empty()) return what_at(text, at, "not understood");
  const Read<Ids> what{text.latest, at};
  if (const auto turn = turn_at(text, at))
    return of_each(what, turn->end, [&](const std::string& id) { return edit::Turn{id, radians(turn->value)}; });
  auto sized = read_size(text, what, at);
  // "three quarters of its length would do"
  if (sized) sized->end += longest_in(text.edits.suffices, text.tokens, sized->end);
  for (const auto& other : {sized, recolored(text, what, at), put_there(text, what)})
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
    const auto along = longest_in(text.edits.along, text.tokens, what->end);
    std::size_t behind = what->end;
    const auto turn = turn_at(text, what->end + along);
    // "turn it round to face the piano"
    const bool says_towards = turn && longest_in(text.edits.faces, text.tokens, turn->end) > 0;
    if (says_towards) behind = turn->end;
    else if (turn) return turned(text, *what, *turn, along > 0);
    auto length = longest_in(text.edits.faces, text.tokens, behind);
    if (length == 0) length = longest_in(text.edits.to, text.tokens, behind);
    if (length == 0) continue;
    length += behind - what->end;
    const auto place = place_named_at(text, what->end + length);
    if (place && place->place == brief::Place::wall && place->wall < 0 && !place->opposite)
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
