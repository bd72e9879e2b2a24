#include "clause.h"

#include <algorithm>

#include "brief/placement_phrase.h"
#include "clause_parts.h"
#include "language/inflection.h"
#include "edit/operations.h"
#include "edit/placing.h"
#include "roomgen/base/text.h"
#include "solve/ways.h"
#include "spoken_clause.h"

namespace roomgen {

namespace {

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
  add.size = thing.told_size();
  return add;
}

bool is_small(const EditText& text, const std::string& category) {
  return text.kinds.get(category).mount == Mount::surface;
}

// As such things usually stand to such a host: chairs around a table, what is small on it, all else near it.
std::vector<Relation> usual_relations_to(const EditText& text, const std::string& category, const Object& host) {
  if (is_small(text, category)) return {{RelationKind::on, host.id}};
  const auto& arrangements = built_in_arrangements();
  if (arrangements)
    if (auto usual = ways_to(arrangements->get(text.kinds, category, text.kinds.get(category).mount), text.kinds, host);
        !usual.empty())
      return usual;
  return {{RelationKind::near, host.id}};
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
    add.relations = usual_relations_to(text, add.category, *then.object(host));
    come(then, add, more);
  }
  clause.operations.insert(clause.operations.end(), more.operations.begin(), more.operations.end());
  clause.coming.insert(clause.coming.end(), more.coming.begin(), more.coming.end());
  clause.end = company.back().end;
  for (const char* of_it : {"on", "around", "at"})
    if (text.is_word(clause.end, of_it) && text.is_word(clause.end + 1, "it")) clause.end += 2;
  return clause;
}

// As what was there stood: "put a plant in its place".
Result<std::vector<Relation>> relations_at(const EditText& text, const Whereabouts& place) {
  if (!place.spot) return place.relations;
  const Object* was = text.object(place.spot->of);
  const bool is_gone = std::count(text.gone.begin(), text.gone.end(), place.spot->of) > 0;
  if (was && is_gone && !was->relations.empty()) return was->relations;
  return not_understood(place.spot->of + " stands there; say what becomes of it, or replace it");
}

// "a candle on every table": at each of the places as many.
MayRead<Clause> read_shared(const EditText& text, const std::vector<NamedThing>& wanted, std::size_t at) {
  const auto shared = shared_places_at(text, at, is_small(text, wanted.front().kind.category->name));
  if (!shared) return std::nullopt;
  if (!*shared) return shared->error();
  const auto& places = (*shared)->value.places;
  Clause clause;
  for (const auto& relations : places)
    for (const auto& thing : wanted) {
      edit::Add add = add_of(thing);
      // "two lamps on either side of the bed" are two.
      const bool is_divided = (*shared)->value.flanks && !(*shared)->value.each && add.count > 1;
      if (is_divided && static_cast<std::size_t>(add.count) != places.size())
        return not_understood(std::to_string(add.count) + " of them cannot be shared out among " +
                              std::to_string(places.size()) + " places");
      if (is_divided) add.count = 1;
      add.relations = relations;
      come(text, add, clause);
    }
  clause.end = (*shared)->end;
  return Read<Clause>{clause, (*shared)->end};
}

ReadClause ended(const EditText& text, ReadClause clause) {
  if (clause) clause->end += longest_in(text.edits.welcome, text.tokens, clause->end);
  return clause;
}

// "a bigger fridge", where there is one: that shall be it, and not a second one.
bool is_better_one(const EditText& text, const NamedThing& thing) {
  if (thing.further || thing.count > 1 || fitting(text, thing).size() != 1) return false;
  return std::any_of(thing.looks.begin(), thing.looks.end(), [&](const std::string& look) {
    if (text.edits.betters.count(look)) return true;
    const auto plain = language::positive(look);
    return plain && *plain != look;
  });
}

// "a larger rug under the table", where there is one; a place at which it is not is that of another one.
std::optional<ReadClause> read_better_one(const EditText& text, const NamedThing& thing) {
  if (!is_better_one(text, thing)) return std::nullopt;
  const Ids there = fitting(text, thing);
  std::size_t end = thing.end;
  if (const auto place = destination_at(text, end, there); place && *place && !(*place)->spot) {
    const Object* object = find_object(text.scene, there.front());
    if (object && lost_relations(*object, (*place)->relations, text.scene, text.kinds).empty()) end = (*place)->end;
  }
  auto better = of_each({there, end}, end, [&](const std::string& id) {
    return edit::Replace{id, "", thing.description(), thing.told_size()};
  });
  return goes_to_its_end(text, better) ? std::optional(better) : std::nullopt;
}

ReadClause read_things_to_add(const EditText& text, std::size_t at) {
  const auto wanted = new_things_at(text, at, true);
  if (wanted.empty()) return what_at(text, at, "it is not clear what shall be added");
  if (wanted.size() == 1)
    if (auto better = read_better_one(text, wanted.front())) return *better;
  Clause clause;
  clause.end = wanted.back().end;
  if (const auto shared = read_shared(text, wanted, clause.end)) {
    if (!*shared) return shared->error();
    return (*shared)->value;
  }
  // "a table with two chairs in the corner": the place comes last, and is the table's.
  if (wanted.size() == 1 && text.is_word(clause.end, "with")) {
    come(text, add_of(wanted.front()), clause);
    clause = with_company(text, std::move(clause));
  }
  if (longest_in(text.edits.substitutes, text.tokens, clause.end) > 0 && wanted.size() == 1)
    return read_instead(text, clause.end, wanted.front());
  std::size_t where = clause.end;
  // "let a lamp stand at its head"
  if (const auto verb = verb_at(text, where); verb && verb->meaning == "put") where += verb->length, clause.end = where;
  where = text.behind_comma(where);
  // "a second crib alongside it"
  EditText here = text;
  if (here.latest.empty()) here.latest = fitting(text, wanted.front());
  const auto place = destination_at(here, where, {});
  if (place && !*place && where == clause.end) return place->error();
  std::vector<Relation> relations;
  if (place && *place) {
    auto at_place = relations_at(text, **place);
    if (!at_place) return at_place.error();
    relations = *std::move(at_place);
    // "add a charger to the desk"
    const Object* host = text.is_word(where, "to") && relations.size() == 1
                             ? find_object(text.scene, relations.front().target)
                             : nullptr;
    if (host && relations.front().kind == RelationKind::near && is_small(text, wanted.front().kind.category->name) &&
        text.kinds.get(host->category).supports)
      relations.front().kind = RelationKind::on;
    clause.end = (*place)->end;
  }
  if (!clause.operations.empty()) {
    if (!relations.empty()) std::get<edit::Add>(clause.operations.front()).relations = relations;
    return clause;
  }
  for (const auto& thing : wanted) {
    edit::Add add = add_of(thing);
    add.relations = relations;
    if (place && *place) add.room = (*place)->room;
    come(text, add, clause);
  }
  return with_company(text, std::move(clause));
}

}  // namespace

ReadClause read_better(const EditText& text, std::size_t at) {
  const auto thing = named_thing_at(text, at);
  if (!thing || !thing->kind.category || (!thing->bare && thing->which != NamedThing::Which::indefinite))
    return what_at(text, at, "not understood");
  auto better = read_better_one(text, *thing);
  return better ? *std::move(better) : what_at(text, at, "not understood");
}

ReadClause read_add(const EditText& text, std::size_t at) { return ended(text, read_things_to_add(text, at)); }

bool brings_something(const EditText& text, std::size_t at) { return new_thing_at(text, at).has_value(); }

// "give the desk a lamp", "the desk needs 60 cm of free space to the wall", "the bed could do with a darker brown"
ReadClause read_give(const EditText& text, std::size_t at) {
  const auto owner = things(text, at, true);
  if (!owner) return owner.error();
  if (const auto gap = gap_at(text, owner->end, owner->value))
    return *gap ? keep_gap(text, **gap) : ReadClause(gap->error());
  if (const auto parts = parts_at(text, owner->end))
    return of_each(*owner, parts->end, [&](const std::string& id) { return edit::Reform{id, "with " + parts->value}; });
  const auto wanted = new_things_at(text, owner->end);
  if (wanted.empty()) {
    if (auto looks = recolored(text, *owner, owner->end)) return looks;
    return what_at(text, owner->end, "it is not clear what shall be added");
  }
  Clause clause;
  for (const auto& id : owner->value)
    for (const auto& thing : wanted) {
      edit::Add add = add_of(thing);
      const Object* host = text.object(id);
      add.relations = host ? usual_relations_to(text, add.category, *host)
                           : std::vector<Relation>{{RelationKind::near, id}};
      come(text, add, clause);
    }
  clause.end = wanted.back().end;
  return clause;
}

}  // namespace roomgen
