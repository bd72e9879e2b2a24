#include <algorithm>

#include "clause.h"
#include "clause_parts.h"
#include "edit/operations.h"
#include "roomgen/base/text.h"
#include "spoken_clause.h"
#include "wording.h"

namespace roomgen {

namespace {

using Which = NamedThing::Which;

constexpr std::size_t flank_words = 4;  // "on either side of"

// A room of a dwelling of which nothing would be left.
const Room* room_emptied_by(const EditText& text, const Ids& ids) {
  for (const auto& room : text.scene.rooms) {
    std::size_t there = 0, gone = 0;
    for (const auto& object : text.scene.objects) {
      if (object.room != room.id) continue;
      ++there;
      gone += std::count(ids.begin(), ids.end(), object.id) > 0 ? 1 : 0;
    }
    if (there > 0 && gone == there) return &room;
  }
  return nullptr;
}

ReadClause read_remove(const EditText& text, std::size_t at) {
  for (const bool with_places : {false, true}) {
    const auto all = things(text, at, with_places);
    if (!all) continue;
    const std::size_t end = text.behind_comma(all->end);
    if (const auto along = longest_in(text.edits.along, text.tokens, end))
      return Clause{{edit::Remove{all->value, true}}, {}, {}, end + along, all->value};
  }
  const auto what = things(text, at, true);
  if (!what) return what.error();
  const auto thing = named_thing_at(text, at);
  const std::size_t count = what->value.size(), all = text.scene.objects.size();
  // "all but one of the plants", where "all" alone was read
  const bool is_most_of_room = thing && what->end == thing->end && 2 * count > all;
  if (thing && thing->which == Which::everything && (count == all || is_most_of_room))
    return not_understood("that would empty the room; name what shall go");
  if (thing && thing->which == Which::everything)
    if (const Room* emptied = room_emptied_by(text, what->value))
      return not_understood("that would empty " + emptied->id + "; name what shall go");
  return Clause{{edit::Remove{what->value, false}}, {}, {}, what->end, what->value};
}

ReadClause read_rearrange(const EditText& text, std::size_t at) {
  const auto what = things(text, at, true);
  if (!what) return what.error();
  const std::size_t end = what->end + longest_in(text.edits.along, text.tokens, what->end);
  return Clause{{edit::Rearrange{what->value}}, what->value, {}, end};
}

ReadClause read_revert(const EditText& text, std::size_t at) {
  const auto length = longest_in(text.edits.back, text.tokens, at);
  return Clause{{edit::Revert{}}, {}, {}, at + length};
}

// "have a fourth stool at the island", "have the desk face the window", "make the rug bigger"
ReadClause read_have(const EditText& text, std::size_t at) {
  auto made = read_make(text, at);
  if (goes_to_its_end(text, made)) return made;
  auto put = read_put(text, at, true);
  return goes_to_its_end(text, put) ? put : made;
}

// "have the desks moved", "I want the lamp to hang lower": what is about something is an order too.
ReadClause read_embedded(const EditText& text, std::size_t at) {
  auto order = clause_with_subject(text, at, [](const EditText& inner, const SaidVerb& verb, std::size_t begin) {
    return read_verb(inner, verb.meaning, verb.words, begin);
  });
  return order ? *std::move(order) : what_at(text, at, "not understood");
}

ReadClause first_whole(const EditText& text, std::initializer_list<ReadClause> readings) {
  for (const auto& clause : readings)
    if (goes_to_its_end(text, clause)) return clause;
  return *readings.begin();
}

// "clear the desk": what is on it, not the desk.
ReadClause cleared(const EditText& text, const Clause& surfaces) {
  Ids on_them;
  for (const auto& object : text.scene.objects)
    if (std::count(surfaces.gone.begin(), surfaces.gone.end(), object.on) > 0) on_them.push_back(object.id);
  if (on_them.empty()) return not_understood("nothing stands on " + join(surfaces.gone, ", "));
  return Clause{{edit::Remove{on_them, false}}, surfaces.gone, {}, surfaces.end, on_them};
}

// "I'd prefer a round rug", where there is one: that instead.
ReadClause read_preferred(const EditText& text, std::size_t at) {
  const auto thing = new_thing_at(text, at);
  const Ids there = thing && !thing->further ? fitting(text, *thing) : Ids();
  if (there.size() != 1) return what_at(text, at, "not understood");
  return of_each({there, thing->end}, thing->end, [&](const std::string& id) {
    return edit::Replace{id, "", thing->description(), thing->told_size()};
  });
}

// "throw out the rug", "toss a blanket over the sofa"
ReadClause read_throw(const EditText& text, std::size_t at) {
  return first_whole(text, {read_remove(text, at), read_put(text, at, true)});
}

// "duplicate the lamp next to the bed"
ReadClause read_copy(const EditText& text, std::size_t at) {
  const auto what = things(text, at, false);
  if (!what) return what.error();
  const auto place = destination_at(text, what->end, what->value);
  if (place && !*place) return place->error();
  if (place && (*place)->spot) return what_at(text, what->end, "something stands there");
  return of_each(*what, place ? (*place)->end : what->end, [&](const std::string& id) {
    const Object& object = *text.object(id);
    return edit::Add{object.category, object.description, object.size, 1,
                     place ? (*place)->relations : std::vector<Relation>()};
  });
}

// "leave 70 cm between the bed and the wardrobe", "keep only two chairs", "keep the sofa where it is"
ReadClause read_keep(const EditText& text, std::size_t at) {
  if (const auto gap = gap_at(text, at, text.latest)) return *gap ? keep_gap(text, **gap) : ReadClause(gap->error());
  if (const auto only = longest_in(text.edits.only_these, text.tokens, at)) return read_only_these(text, at + only);
  return read_lock(text, at, true, true);
}

// "take the lamp off the nightstand", and nowhere else.
ReadClause read_take_off(const EditText& text, std::size_t at) {
  const auto thing = named_thing_at(text, at);
  if (!thing || !text.is_word(thing->end, "off")) return what_at(text, at, "not understood");
  const auto what = things(text, at, true);
  if (!what || what->end <= thing->end + 1) return what_at(text, at, "not understood");
  return Clause{{edit::Remove{what->value, false}}, what->value, {}, what->end, what->value};
}

// "we need a lamp", "I need the desk wider"
ReadClause read_bring(const EditText& text, const std::string& verb, std::size_t at) {
  auto added = read_add(text, at);
  if (added) return added;
  if (auto moved = read_put(text, at, false); goes_to_its_end(text, moved)) return moved;
  const bool is_wish = verb.starts_with("i ") || verb.starts_with("we ");
  if (is_wish)
    for (auto other : {read_embedded(text, at), read_fragment(text, at)})
      if (goes_to_its_end(text, other)) return other;
  // "I fancy an arched one": for what was spoken of.
  const auto other = text.latest.empty() ? added : read_another(text, at);
  return goes_to_its_end(text, other) ? other : added;
}

// "the bowl can stay"
ReadClause read_stay(const EditText& text, std::size_t at) {
  const auto what = things(text, at, true);
  if (!what) return what.error();
  const auto length = longest_in(text.edits.stays, text.tokens, what->end);
  if (length == 0) return what_at(text, what->end, "not understood");
  // "… in front of the bookcase": where it is anyway.
  const std::size_t end = what->end + length;
  const auto place = destination_at(text, end, what->value);
  return Clause{{}, what->value, {}, place && *place ? (*place)->end : end};
}

}  // namespace

ReadClause read_lock(const EditText& text, std::size_t at, bool locked, bool must_say_where) {
  auto what = things(text, at, false);
  if (!what) return what.error();
  std::size_t end = what->end;
  while (const auto length = longest_in(text.edits.where_they_are, text.tokens, end)) end += length;
  if (must_say_where && end == what->end) return what_at(text, end, "it is not clear what shall be kept");
  return Clause{{edit::Lock{what->value, locked}}, what->value, {}, end};
}

ReadClause read_wish(const EditText& text, std::size_t at) {
  if (const auto verb = verb_at(text, at); verb && !verb->inflected && verb->meaning != "give")
    if (auto order = read_verb(text, verb->meaning, verb->words, at + verb->length); goes_to_its_end(text, order))
      return order;
  return first_whole(text, {read_embedded(text, at), read_fragment(text, at)});
}

ReadClause read_being(const EditText& text, std::size_t at) {
  for (const std::size_t subject : ends_of_subject(text, at)) {
    const std::size_t end = behind_modals(text, subject);
    if (end == subject) continue;
    auto made = read_verb(without(text, subject, end), "make", "make", at);
    if (!made) continue;
    made->end += end - subject;
    if (goes_to_its_end(text, made)) return made;
  }
  return what_at(text, at, "not understood");
}

ReadClause read_verb(const EditText& text, const std::string& meaning, const std::string& verb, std::size_t at) {
  const bool may_be_of_size = meaning == "resize" || meaning == "make" || meaning == "put" || meaning == "change" ||
                              meaning == "want" || text.edits.lifts.count(verb) > 0;
  if (may_be_of_size)
    if (auto size = read_property(text, at, verb); size && goes_to_its_end(text, *size)) return *std::move(size);
  if (auto order = read_room_order(text, meaning, verb, at)) return *std::move(order);
  if (meaning == "make" || meaning == "want" || meaning == "resize")
    if (auto form = read_form(text, at); form && goes_to_its_end(text, *form)) return *std::move(form);
  if (meaning == "unwanted") return read_remove(text, at);
  if (meaning == "rearrange") return read_rearrange(text, at);
  if (meaning == "remove" || meaning == "clear") {
    auto gone = read_remove(text, at);
    const bool is_surface =
        meaning == "clear" && gone && !verb.ends_with("out") && named_thing_at(text, at)->which != Which::everything;
    return is_surface ? cleared(text, *gone) : gone;
  }
  if (const auto gap = gap_at(text, at, text.latest)) return *gap ? keep_gap(text, **gap) : ReadClause(gap->error());
  if (meaning == "add") return read_bring(text, verb, at);
  if (meaning == "copy") return read_copy(text, at);
  if (meaning == "flank") {
    const auto flanked = with_flanks(text, at);
    auto added = flanked ? read_add(*flanked, at) : what_at(text, at, "it is not clear what shall stand there");
    if (added) added->end -= flank_words - 1;
    return added;
  }
  if (meaning == "give") return first_whole(text, {read_give(text, at), read_bring(text, verb, at)});
  if (verb == "take")
    if (auto gone = read_take_off(text, at); goes_to_its_end(text, gone)) return gone;
  if (const auto lift = text.edits.lifts.find(verb); lift != text.edits.lifts.end())
    if (auto lifted = read_lift(text, at, lift->second); goes_to_its_end(text, lifted)) return lifted;
  if (meaning == "throw") return read_throw(text, at);
  if (meaning == "put" || meaning == "move") return read_put(text, at, meaning == "put");
  if (meaning == "tuck") return read_tuck(text, at);
  if (meaning == "untuck") return first_whole(text, {read_put(text, at, false), read_untuck(text, at)});
  if (meaning == "line") return read_line(text, at);
  if (meaning == "turn") return first_whole(text, {read_turn(text, at), read_change(text, at)});
  if (meaning == "swap") return read_swap(text, at);
  if (meaning == "replace") return read_replace(text, at);
  if (meaning == "change") return read_change(text, at);
  if (meaning == "make") return first_whole(text, {read_have(text, at), read_embedded(text, at)});
  if (meaning == "resize") return read_resize(text, at, verb);
  if (meaning == "paint") return read_looks(text, at);
  const bool is_preferred = verb.ends_with("prefer") || verb.find("rather") != std::string::npos;
  if (meaning == "want" && is_preferred)
    if (auto other = read_preferred(text, at); goes_to_its_end(text, other)) return other;
  if (meaning == "want") return read_wish(text, at);
  if (meaning == "keep") return read_keep(text, at);
  if (meaning == "lock") return read_lock(text, at, true, false);
  if (meaning == "unlock") return read_lock(text, at, false, false);
  if (meaning == "centre") return read_centre(text, at);
  return read_revert(text, at);
}

ReadClause read_fragment(const EditText& text, std::size_t at) {
  if (auto stay = read_stay(text, at); goes_to_its_end(text, stay)) return stay;
  if (auto enough = read_enough(text, at); goes_to_its_end(text, enough)) return enough;
  if (const auto gap = gap_at(text, at, text.latest)) return *gap ? keep_gap(text, **gap) : ReadClause(gap->error());
  if (const auto only = longest_in(text.edits.only_these, text.tokens, at))
    if (auto those = read_only_these(text, at + only); goes_to_its_end(text, those)) return those;
  if (room_part_at(text, at)) return first_whole(text, {read_looks(text, at), read_being(text, at)});
  if (auto form = read_form(text, at); form && goes_to_its_end(text, *form)) return *std::move(form);
  ReadClause put = read_put(text, at, true);
  if (goes_to_its_end(text, put)) return put;
  for (const auto& other : {read_better(text, at), read_make(text, at), read_turn(text, at), read_looks_first(text, at),
                            read_turn_first(text, at), read_being(text, at), read_ellipsis(text, at)})
    if (goes_to_its_end(text, other)) return other;
  return put;
}

}  // namespace roomgen
