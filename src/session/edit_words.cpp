#include "edit_words.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "brief/placement_phrase.h"
#include "clause_parts.h"
#include "language/measure.h"
#include "operations.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

using Which = NamedThing::Which;
using Token = design::Token;

constexpr double usual_shift = 0.5;  // metres, where nobody says how far

/// One clause: what it asks for, and what it spoke of.
struct Clause {
  std::vector<edit::Operation> operations;
  Ids about;
  std::vector<Object> coming;  ///< that it adds
  std::size_t end = 0;
};
using ReadClause = Result<Clause>;

Error what_at(const EditText& text, std::size_t at, const std::string& what) {
  const std::string rest = text.words_from(at, std::min(at + 6, text.tokens.size()));
  return not_understood(what + (rest.empty() ? "" : " at \"" + rest + "\""));
}

// ---- What things there are to be said of -------------------------------------------------------

Result<Read<Ids>> things(const EditText& text, std::size_t at, bool with_places) {
  auto found = things_at(text, at, with_places);
  // What follows may be no place at all: "have both armchairs face the TV".
  if (with_places && found && !*found)
    if (const auto plain = things_at(text, at, false); plain && *plain) found = plain;
  if (!found) return what_at(text, at, "it is not clear what is meant");
  return *found;
}

ReadClause of_each(const Read<Ids>& read, std::size_t end, const std::function<edit::Operation(const std::string&)>& make) {
  Clause clause;
  clause.about = read.value;
  clause.end = end;
  for (const auto& id : read.value) clause.operations.push_back(make(id));
  return clause;
}

// ---- Adding ------------------------------------------------------------------------------------

// Things that a clause adds count as there for the clauses behind it.
void come(const EditText& text, const edit::Add& add, Clause& clause) {
  const Kind& kind = kind_to_add(text.kinds, add);
  Scene so_far = text.scene;
  so_far.objects.insert(so_far.objects.end(), text.coming.begin(), text.coming.end());
  so_far.objects.insert(so_far.objects.end(), clause.coming.begin(), clause.coming.end());
  for (int i = 0; i < add.count; ++i) {
    Object object;
    object.category = kind.name.empty() ? lower(add.category) : kind.name;
    object.id = next_id(so_far, object.category, i);
    object.description = add.description;
    object.mount = kind.mount;
    clause.about.push_back(object.id);
    clause.coming.push_back(std::move(object));
  }
  clause.operations.push_back(add);
}

edit::Add add_of(const NamedThing& thing) {
  edit::Add add;
  add.category = thing.kind.category->name;
  add.description = thing.description();
  add.count = std::max(1, thing.count);
  return add;
}

// "on each desk": one for each.
std::optional<Result<Read<std::vector<Relation>>>> each_target(const EditText& text, std::size_t at) {
  const auto said = longest(text.words.placements, text.tokens, at);
  if (!said || said.value->relations.size() != 1) return std::nullopt;
  const auto thing = named_thing_at(text, at + said.length);
  if (!thing || thing->which != Which::all) return std::nullopt;
  const auto ids = meant(text, *thing);
  if (!ids) return ids.error();
  std::vector<Relation> relations;
  for (const auto& id : *ids) relations.push_back({said.value->relations.front(), id});
  return Read<std::vector<Relation>>{relations, thing->end};
}

// "a monitor and a keyboard"
std::vector<NamedThing> new_things_at(const EditText& text, std::size_t at) {
  std::vector<NamedThing> all;
  for (std::size_t next = at;;) {
    const auto thing = named_thing_at(text, next);
    if (!thing || !thing->kind.category || (thing->which != Which::indefinite && !thing->further)) break;
    all.push_back(*thing);
    next = thing->end;
    if (!text.is_word(next, "and") && !(next < text.tokens.size() && text.tokens[next].kind == Token::Kind::comma)) break;
    ++next;
  }
  return all;
}

// "a table with two chairs": what comes with it stands on it, or at it.
Clause with_company(const EditText& text, Clause clause) {
  if (clause.coming.size() != 1 || !text.is_word(clause.end, "with")) return clause;
  const auto company = new_things_at(text, clause.end + 1);
  if (company.empty()) return clause;
  EditText then = text;
  then.coming.insert(then.coming.end(), clause.coming.begin(), clause.coming.end());
  const std::string host = clause.about.front();
  Clause more;
  for (const auto& thing : company) {
    edit::Add add = add_of(thing);
    const bool is_small = text.kinds.get(add.category).mount == Mount::surface;
    add.relations = {{is_small ? RelationKind::on : RelationKind::near, host}};
    come(then, add, more);
  }
  clause.operations.insert(clause.operations.end(), more.operations.begin(), more.operations.end());
  clause.coming.insert(clause.coming.end(), more.coming.begin(), more.coming.end());
  clause.end = company.back().end;
  for (const char* of_it : {"on", "around", "at"})
    if (text.is_word(clause.end, of_it) && text.is_word(clause.end + 1, "it")) clause.end += 2;
  return clause;
}

ReadClause read_add(const EditText& text, std::size_t at) {
  const auto wanted = new_things_at(text, at);
  if (wanted.empty()) return what_at(text, at, "it is not clear what shall be added");
  Clause clause;
  clause.end = wanted.back().end;
  if (const auto each = each_target(text, clause.end)) {
    if (!*each) return each->error();
    for (const auto& relation : (*each)->value)
      for (const auto& thing : wanted) {
        edit::Add add = add_of(thing);
        add.relations = {relation};
        come(text, add, clause);
      }
    clause.end = (*each)->end;
    return clause;
  }
  // "a table with two chairs in the corner": the place comes last, and is the table's.
  if (wanted.size() == 1 && text.is_word(clause.end, "with")) {
    come(text, add_of(wanted.front()), clause);
    clause = with_company(text, std::move(clause));
  }
  const auto place = destination_at(text, clause.end, {});
  if (place && !*place) return place->error();
  if (place) clause.end = (*place)->end;
  if (!clause.operations.empty()) {
    if (place) std::get<edit::Add>(clause.operations.front()).relations = (*place)->relations;
    return clause;
  }
  for (const auto& thing : wanted) {
    edit::Add add = add_of(thing);
    if (place) add.relations = (*place)->relations;
    come(text, add, clause);
  }
  return clause;
}

// "give the desk a second monitor"
ReadClause read_give(const EditText& text, std::size_t at) {
  const auto owner = things(text, at, true);
  if (!owner) return owner.error();
  const auto wanted = new_things_at(text, owner->end);
  if (wanted.empty()) return what_at(text, owner->end, "it is not clear what shall be added");
  Clause clause;
  for (const auto& id : owner->value)
    for (const auto& thing : wanted) {
      edit::Add add = add_of(thing);
      const Kind& kind = text.kinds.get(add.category);
      const bool is_small = kind.mount == Mount::surface;
      add.relations = {{is_small ? RelationKind::on : RelationKind::near, id}};
      come(text, add, clause);
    }
  clause.end = wanted.back().end;
  return clause;
}

// ---- Moving ------------------------------------------------------------------------------------

Vec2 middle_of(const EditText& text, const Object& object, const std::string& target) {
  if (const Object* other = find_object(text.scene, target)) return other->position.head<2>();
  const Room& room = room_of(text.scene, object);
  if (const Opening* opening = find_opening(room, target)) return segment(room, *opening).middle();
  for (std::size_t k = 0; k < room.polygon.size(); ++k)
    if (target == "wall-" + std::to_string(k)) return closest_point(room.polygon.edge(k), object.position.head<2>());
  return object.position.head<2>();
}

ReadClause read_shift(const EditText& text, const Ids& ids, const Shifting& how) {
  Clause clause;
  clause.about = ids;
  clause.end = how.end;
  for (const auto& id : ids) {
    const Object* object = find_object(text.scene, id);
    if (!object) return not_understood(id + " has no place yet from which it could move");
    if (!how.metres && !how.direction) {
      const RelationKind kind = how.from ? RelationKind::far : RelationKind::near;
      clause.operations.push_back(edit::Move{id, {{kind, how.from ? *how.from : *how.towards}}});
      continue;
    }
    Vec3 direction = how.direction.value_or(Vec3::Zero());
    if (!how.direction) {
      direction.head<2>() = middle_of(text, *object, how.from ? *how.from : *how.towards) - Vec2(object->position.head<2>());
      if (direction.norm() < 1e-6) return not_understood("it is not clear which way " + id + " shall move");
      direction = direction.normalized() * (how.from ? -1.0 : 1.0);
    }
    clause.operations.push_back(edit::Shift{id, direction * how.metres.value_or(usual_shift)});
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

ReadClause put_there(const EditText& text, Read<Ids> what) {
  if (const auto length = longest_in(text.edits.goes_away, text.tokens, what.end); length > 0 && text.ends(what.end + length))
    return Clause{{edit::Remove{what.value, false}}, {}, {}, what.end + length};
  what.end += longest_in(text.edits.modals, text.tokens, what.end);
  if (const auto length = longest_in(text.edits.refused, text.tokens, what.end); length > 0 && text.ends(what.end + length))
    return what_at(text, what.end, "that names no place");
  if (longest_in(text.edits.faces, text.tokens, what.end) > 0) {
    Clause facing{{}, what.value, {}, what.end};
    facing.end = read_facing(text, what.end, facing);
    if (facing.end > what.end) return facing;
  }
  if (const auto shifting = shifting_at(text, what.end, what.value)) {
    if (!*shifting) return shifting->error();
    if (text.ends((*shifting)->end) || longest_in(text.edits.closers, text.tokens, (*shifting)->end) > 0)
      return read_shift(text, what.value, **shifting);
  }
  const auto place = destination_at(text, what.end, what.value);
  if (!place) return what_at(text, what.end, "it is not clear where to");
  if (!*place) return place->error();
  auto clause = of_each(what, (*place)->end,
                        [&](const std::string& id) { return edit::Move{id, (*place)->relations}; });
  clause->end = read_facing(text, clause->end, *clause);
  return clause;
}

bool goes_to_its_end(const EditText& text, const ReadClause& clause) {
  return clause && (text.ends(clause->end) || longest_in(text.edits.closers, text.tokens, clause->end) > 0);
}

// "put the vase on the table", and "move the vase on the table to the shelf": what is said last is where to.
ReadClause read_put(const EditText& text, std::size_t at, bool may_add) {
  const auto thing = named_thing_at(text, at);
  // "put it back": what went may be there no more.
  if (thing && thing->which == Which::pronoun)
    if (const auto length = longest_in(text.edits.back, text.tokens, thing->end);
        length > 0 && text.is_word(thing->end, "back") && text.ends(thing->end + length))
      return Clause{{edit::Revert{}}, {}, {}, thing->end + length};
  if (may_add && thing && thing->kind.category && thing->which == Which::indefinite) return read_add(text, at);
  const auto plain = things(text, at, false);
  ReadClause first = plain ? put_there(text, *plain) : ReadClause(plain.error());
  if (goes_to_its_end(text, first)) return first;
  const auto placed = things(text, at, true);
  if (placed && (!plain || placed->end != plain->end)) {
    if (auto second = put_there(text, *placed); goes_to_its_end(text, second)) return second;
  }
  return first;
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

std::optional<Read<double>> turn_at(const EditText& text, std::size_t at) {
  if (text.is_word(at, "by")) ++at;
  if (const auto turn = longest(text.edits.turns, text.tokens, at)) return Read<double>{*turn.value, at + turn.length};
  double sign = 1.0;
  const auto before = longest(text.edits.turn_directions, text.tokens, at);
  if (before) sign = *before.value, at += before.length;
  if (text.is_word(at, "by")) ++at;
  if (at >= text.tokens.size() || text.tokens[at].kind != Token::Kind::number) return std::nullopt;
  const double degrees = text.tokens[at].value;
  if (!text.is_word(at + 1, "degrees") && !text.is_word(at + 1, "degree") && !text.is_word(at + 1, "deg")) return std::nullopt;
  at += 2;
  if (const auto behind = longest(text.edits.turn_directions, text.tokens, at))
    sign = *behind.value, at += behind.length;
  return Read<double>{sign * degrees, at};
}

ReadClause read_turn(const EditText& text, std::size_t at) {
  ReadClause failed = what_at(text, at, "it is not clear which way to turn");
  for (const bool with_places : {false, true}) {
    const auto what = things(text, at, with_places);
    if (!what) {
      if (!with_places) failed = what.error();
      continue;
    }
    if (const auto turn = turn_at(text, what->end))
      return of_each(*what, turn->end, [&](const std::string& id) { return edit::Turn{id, radians(turn->value)}; });
    auto length = longest_in(text.edits.faces, text.tokens, what->end);
    if (length == 0) length = longest_in(text.edits.to, text.tokens, what->end);
    if (length == 0) continue;
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

// ---- Other things, other looks -----------------------------------------------------------------

ReadClause replaced(const EditText& text, const Read<Ids>& what, std::size_t at) {
  const auto wanted = substitute_at(text, at);
  if (!wanted) return what_at(text, at, "it is not clear by what");
  if (!*wanted) return wanted->error();
  return of_each(what, (*wanted)->end, [&](const std::string& id) {
    const auto& by = (*wanted)->value;
    const Object* object = text.object(id);
    const std::string category = by.category.empty() && object ? object->category : by.category;
    const std::string described = by.category.empty() ? by.description + " " + category : by.description;
    return edit::Replace{id, by.category, described};
  });
}

ReadClause read_replace(const EditText& text, std::size_t at) {
  const auto what = things(text, at, true);
  if (!what) return what.error();
  for (const char* by : {"with", "by", "for"})
    if (text.is_word(what->end, by)) return replaced(text, *what, what->end + 1);
  return what_at(text, what->end, "it is not clear by what");
}

bool names_new(const EditText& text, std::size_t at) {
  const auto thing = named_thing_at(text, at);
  return !thing || thing->which == Which::indefinite || (thing->bare && fitting(text, *thing).empty());
}

ReadClause read_swap(const EditText& text, std::size_t at) {
  const auto first = things_at(text, at, true);
  if (first && *first && text.is_word((*first)->end, "for") && names_new(text, (*first)->end + 1))
    return replaced(text, **first, (*first)->end + 1);
  Ids both;
  std::size_t end = at;
  if (first && *first && (*first)->value.size() == 2) {
    both = (*first)->value;
    end = (*first)->end;
  } else {
    if (!first) return what_at(text, at, "it is not clear what is meant");
    if (!*first) return first->error();
    end = (*first)->end;
    if (!text.is_word(end, "with") && !text.is_word(end, "and") && !text.is_word(end, "for"))
      return what_at(text, end, "it is not clear with what");
    const auto second = things(text, end + 1, true);
    if (!second) return second.error();
    both = (*first)->value;
    both.insert(both.end(), second->value.begin(), second->value.end());
    end = second->end;
  }
  if (both.size() != 2) return not_understood("swapping takes two things, and " + join(both, ", ") + " were named");
  return Clause{{edit::Swap{both[0], both[1]}}, both, {}, end};
}

// "the walls"
std::optional<Read<std::string>> room_part_at(const EditText& text, std::size_t at) {
  while (at < text.tokens.size() && (text.words.definite.count(text.tokens[at].text) || text.is_word(at, "all"))) ++at;
  const auto part = longest(text.edits.room_parts, text.tokens, at, 2);
  if (!part) return std::nullopt;
  return Read<std::string>{*part.value, at + part.length};
}

ReadClause read_looks(const EditText& text, std::size_t at) {
  if (const auto part = room_part_at(text, at)) {
    const auto looks = looks_at(text, part->end, true);
    if (looks && *looks) return Clause{{edit::Cover{part->value, (*looks)->value, ""}}, {}, {}, (*looks)->end};
  }
  const auto what = things(text, at, true);
  const auto plain = things(text, at, false);
  for (const auto* read : {&what, &plain}) {
    if (!*read) continue;
    const auto looks = looks_at(text, (*read)->end, false);
    if (looks && *looks)
      return of_each(**read, (*looks)->end, [&](const std::string& id) { return edit::Recolor{id, (*looks)->value}; });
  }
  if (!what) return what.error();
  return what_at(text, what->end, "no colour or material is known");
}

ReadClause read_change(const EditText& text, std::size_t at) {
  for (const bool with_places : {true, false}) {
    const auto what = things(text, at, with_places);
    for (const char* to : {"to", "into", "for"}) {
      if (!what || !text.is_word(what->end, to)) continue;
      const auto thing = named_thing_at(text, what->end + 1);
      if (thing && thing->kind.category) return replaced(text, *what, what->end + 1);
    }
  }
  return read_looks(text, at);
}

ReadClause read_size(const EditText& text, const Read<Ids>& what, std::size_t at) {
  const auto size = size_at(text, at);
  if (!size) return what_at(text, at, "it is not clear how large");
  if (!*size) return size->error();
  return of_each(what, (*size)->end, [&](const std::string& id) {
    return edit::Resize{id, resized(find_object(text.scene, id)->size, (*size)->value)};
  });
}

ReadClause read_make(const EditText& text, std::size_t at) {
  const auto what = things(text, at, true);
  if (what) {
    const bool are_there = std::all_of(what->value.begin(), what->value.end(),
                                       [&](const std::string& id) { return find_object(text.scene, id); });
    if (are_there && size_at(text, what->end)) return read_size(text, *what, what->end);
    const auto thing = named_thing_at(text, what->end);
    if (thing && thing->kind.category && thing->which == Which::indefinite) return replaced(text, *what, what->end);
    if (text.is_word(what->end, "face")) {
      const auto target = target_at(text, what->end + 1, what->value);
      if (target && *target)
        return of_each(*what, (*target)->end, [&](const std::string& id) { return edit::Face{id, (*target)->id}; });
    }
  }
  if (!what && !room_part_at(text, at)) return what.error();
  return read_looks(text, at);
}

// "widen the desk by 20 cm"
ReadClause read_resize(const EditText& text, std::size_t at, const std::string& verb) {
  const auto what = things(text, at, true);
  if (!what) return what.error();
  const auto known = text.edits.verbs_of_size.find(verb);
  if (known == text.edits.verbs_of_size.end()) return read_size(text, *what, what->end);
  NewSize change{known->second.side, known->second.factor, {}, {}};
  std::size_t end = what->end;
  if (const auto vague = longest(text.edits.amounts, text.tokens, end)) {
    change.factor = std::sqrt(change.factor);
    end += vague.length;
  }
  if (text.is_word(end, "by") || text.is_word(end, "to")) {
    const auto measure = language::measure_at(text.raw, end + 1);
    if (!measure || measure->kind != language::Measure::Kind::length || change.side == "all")
      return what_at(text, end, "it is not clear how large");
    if (text.is_word(end, "to")) change.exact = measure->values[0];
    else change.more = change.factor > 1.0 ? measure->values[0] : -measure->values[0];
    end += 1 + measure->length;
  }
  for (const auto& id : what->value)
    if (!find_object(text.scene, id)) return not_understood(id + " is not there yet");
  return of_each(*what, end, [&](const std::string& id) {
    return edit::Resize{id, resized(find_object(text.scene, id)->size, change)};
  });
}

// ---- The rest ----------------------------------------------------------------------------------

ReadClause read_remove(const EditText& text, std::size_t at) {
  const auto what = things(text, at, true);
  if (!what) return what.error();
  const auto thing = named_thing_at(text, at);
  const bool is_all_of_room = thing && thing->which == Which::everything && what->value.size() == text.scene.objects.size();
  if (is_all_of_room) return not_understood("that would empty the room; name what shall go");
  return Clause{{edit::Remove{what->value, false}}, {}, {}, what->end};
}

ReadClause read_lock(const EditText& text, std::size_t at, bool locked, bool must_say_where) {
  auto what = things(text, at, false);
  if (!what) return what.error();
  std::size_t end = what->end;
  while (const auto length = longest_in(text.edits.where_they_are, text.tokens, end)) end += length;
  if (must_say_where && end == what->end) return what_at(text, end, "it is not clear what shall be kept");
  return Clause{{edit::Lock{what->value, locked}}, what->value, {}, end};
}

ReadClause read_revert(const EditText& text, std::size_t at) {
  const auto length = longest_in(text.edits.back, text.tokens, at);
  return Clause{{edit::Revert{}}, {}, {}, at + length};
}

ReadClause read_verb(const EditText& text, const std::string& meaning, const std::string& verb, std::size_t at) {
  if (meaning == "unwanted") return read_remove(text, at);
  if (meaning == "remove" || meaning == "clear") {
    auto gone = read_remove(text, at);
    // "clear the desk": what is on it, not the desk.
    if (meaning == "clear" && gone && !verb.ends_with("out") && named_thing_at(text, at)->which != Which::everything)
      return not_understood("say what shall go: \"clear everything off …\", or \"remove …\"");
    return gone;
  }
  if (meaning == "add") return read_add(text, at);
  if (meaning == "give") return read_give(text, at);
  if (meaning == "put" || meaning == "move") return read_put(text, at, meaning == "put");
  if (meaning == "turn") return read_turn(text, at);
  if (meaning == "swap") return read_swap(text, at);
  if (meaning == "replace") return read_replace(text, at);
  if (meaning == "change") return read_change(text, at);
  if (meaning == "make") return read_make(text, at);
  if (meaning == "resize") return read_resize(text, at, verb);
  if (meaning == "paint" || meaning == "want") return read_looks(text, at);
  if (meaning == "lock" || meaning == "keep") return read_lock(text, at, true, meaning == "keep");
  if (meaning == "unlock") return read_lock(text, at, false, false);
  if (meaning == "centre") return read_centre(text, at);
  return read_revert(text, at);
}

// "the bowl can stay"
ReadClause read_stay(const EditText& text, std::size_t at) {
  const auto what = things(text, at, true);
  if (!what) return what.error();
  const auto length = longest_in(text.edits.stays, text.tokens, what->end);
  if (length == 0) return what_at(text, what->end, "not understood");
  return Clause{{}, what->value, {}, what->end + length};
}

// "bin by the door", "walls sage green"
ReadClause read_fragment(const EditText& text, std::size_t at) {
  if (auto stay = read_stay(text, at); goes_to_its_end(text, stay)) return stay;
  if (room_part_at(text, at)) return read_looks(text, at);
  return read_put(text, at, true);
}

/// A sentence, clause by clause.
class EditReader {
 public:
  explicit EditReader(EditText text) : text_(std::move(text)) {}

  Result<std::vector<edit::Operation>> run() {
    for (skip_between(); at_ < text_.tokens.size(); skip_between()) {
      auto clause = read_clause();
      if (clause) clause->end = skip(text_.edits.closers, clause->end);
      if (!clause || !text_.ends(clause->end)) {
        if (skip_explanation()) continue;
        if (!clause) return clause.error();
        return what_at(text_, clause->end, "not understood");
      }
      take(*std::move(clause));
    }
    if (operations_.empty()) return not_understood("nothing in it says what to change");
    return operations_;
  }

 private:
  std::size_t skip(const design::WordSet& words, std::size_t at) const {
    while (const auto length = longest_in(words, text_.tokens, at)) at += length;
    return at;
  }

  void skip_between() {
    for (;;) {
      const auto kind = at_ < text_.tokens.size() ? text_.tokens[at_].kind : Token::Kind::word;
      if (at_ < text_.tokens.size() && (kind == Token::Kind::comma || kind == Token::Kind::stop)) {
        ++at_;
        continue;
      }
      // A verb that looks like an opener is a verb.
      const auto opener = longest_in(text_.edits.openers, text_.tokens, at_);
      if (opener == 0 || longest(text_.edits.verbs, text_.tokens, at_).length > opener) return;
      at_ += opener;
    }
  }

  // "it's draughty", "we need the floor": why, behind what was asked for.
  bool skip_explanation() {
    if (operations_.empty() || longest_in(text_.edits.explanations, text_.tokens, at_) == 0) return false;
    while (at_ < text_.tokens.size() && text_.tokens[at_].kind != Token::Kind::stop &&
           text_.tokens[at_].kind != Token::Kind::comma)
      ++at_;
    return true;
  }

  // "chnage": a verb with two letters in the wrong order, or one too many.
  void correct_verb() {
    auto& token = text_.tokens[at_];
    if (token.kind != Token::Kind::word || token.text.size() < 5 || text_.edits.verbs.count(token.text) ||
        named_thing_at(text_, at_))
      return;
    for (const auto& [verb, meaning] : text_.edits.verbs)
      if (verb.size() >= 5 && edit_distance(token.text, verb) == 1) return void(token.text = verb);
  }

  ReadClause read_clause() {
    correct_verb();
    if (const auto verb = longest(text_.edits.verbs, text_.tokens, at_)) {
      last_meaning_ = *verb.value;
      last_verb_ = text_.words_from(at_, at_ + verb.length);
      auto clause = read_verb(text_, last_meaning_, last_verb_, at_ + verb.length);
      if (clause || operations_.empty()) return clause;
      const auto fragment = read_fragment(text_, at_);
      return goes_to_its_end(text_, fragment) ? fragment : clause;
    }
    // "… and the dresser pale blue": the verb before goes on.
    if (!last_meaning_.empty())
      if (auto same = read_verb(text_, last_meaning_, last_verb_, at_); goes_to_its_end(text_, same)) return same;
    return read_fragment(text_, at_);
  }

  // All that the clause spoke of by name: "the table" behind it is one of these.
  void remember_names(std::size_t end) {
    for (std::size_t i = at_; i < end; ++i) {
      const auto thing = named_thing_at(text_, i);
      if (!thing || thing->which != Which::definite || thing->end > end) continue;
      if (const auto ids = meant(text_, *thing); ids && ids->size() == 1) text_.mentioned.push_back(ids->front());
    }
  }

  void take(Clause clause) {
    remember_names(clause.end);
    at_ = clause.end;
    operations_.insert(operations_.end(), clause.operations.begin(), clause.operations.end());
    text_.mentioned.insert(text_.mentioned.end(), clause.about.begin(), clause.about.end());
    if (!clause.about.empty()) text_.latest = clause.about;
    text_.coming.insert(text_.coming.end(), clause.coming.begin(), clause.coming.end());
  }

  EditText text_;
  std::size_t at_ = 0;
  std::string last_meaning_, last_verb_;
  std::vector<edit::Operation> operations_;
};

constexpr std::size_t most_bytes = 4000, most_words = 400;

}  // namespace

Result<std::vector<edit::Operation>> read_edit(std::string_view sentence, const Scene& scene, const KindTable& kinds,
                                               const Recall& recall) {
  const auto& edits = edit_vocabulary();
  if (!edits) return edits.error();
  const auto& words = design::built_in_vocabulary();
  if (!words) return words.error();
  if (sentence.size() > most_bytes)
    return Error{Error::Kind::limit, "an edit has " + std::to_string(most_bytes) + " bytes at most"};
  auto raw = language::tokenize(sentence, most_words);
  std::erase_if(raw, [](const language::Token& token) {
    return token.kind == language::Token::Kind::quote || token.kind == language::Token::Kind::symbol;
  });
  auto tokens = design::plain_tokens(raw);
  return EditReader({scene, kinds, *edits, *words, std::move(raw), std::move(tokens), {}, {}, {}, recall}).run();
}

}  // namespace roomgen
