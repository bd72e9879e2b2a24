#include "clause.h"

#include <algorithm>

#include "edit/operations.h"
#include "roomgen/base/text.h"
#include "size_phrases.h"
#include "wording.h"

namespace roomgen {

namespace {

ReadClause replaced(const EditText& text, const Read<Ids>& what, std::size_t at) {
  const auto wanted = substitute_at(text, at);
  if (!wanted) return what_at(text, at, "it is not clear by what");
  if (!*wanted) return wanted->error();
  return of_each(what, (*wanted)->end, [&](const std::string& id) {
    const auto& by = (*wanted)->value;
    const Object* object = text.object(id);
    const std::string category = by.category.empty() && object ? object->category : by.category;
    const std::string described =
        !by.category.empty() ? by.description : by.description.empty() ? "" : by.description + " " + category;
    return edit::Replace{id, by.category, described, measured_size(text.kinds.get(category), by.measures)};
  });
}

}  // namespace

ReadClause read_replace(const EditText& text, std::size_t at) {
  for (const bool with_places : {true, false}) {
    const auto what = things(text, at, with_places);
    for (const char* by : {"with", "by", "for", "to"})
      if (what && text.is_word(what->end, by))
        if (auto other = replaced(text, *what, what->end + 1); goes_to_its_end(text, other)) return other;
  }
  const auto what = things(text, at, true);
  if (!what) return what.error();
  for (const char* by : {"with", "by", "for"})
    if (text.is_word(what->end, by)) return replaced(text, *what, what->end + 1);
  if (text.ends(end_of_tail(text, what->end)))
    return of_each(*what, what->end, [](const std::string& id) { return edit::Replace{id}; });
  return what_at(text, what->end, "it is not clear by what");
}

namespace {

// "this small thing", "the old one": the token behind; `at` if it is none.
std::size_t end_of_vague_thing(const EditText& text, std::size_t at) {
  std::size_t end = at;
  while (!text.ends(end) && !text.is_word(end, "thing") && !text.is_word(end, "one")) ++end;
  return text.ends(end) || end == at ? at : end + 1;
}

}  // namespace

ReadClause read_instead(const EditText& text, std::size_t at, const std::optional<NamedThing>& wanted) {
  const std::size_t begin = at + longest_in(text.edits.substitutes, text.tokens, at);
  auto what = things(text, begin, true);
  // "rather than this small thing": what there is of that kind.
  if (!what && wanted)
    if (const auto length = end_of_vague_thing(text, begin); length > begin)
      if (auto ids = fitting(text, *wanted); ids.size() == 1) what = Read<Ids>{std::move(ids), length};
  if (!what) return what.error();
  if (wanted)
    return of_each(*what, what->end, [&](const std::string& id) {
      return edit::Replace{id, wanted->kind.category->name, wanted->description()};
    });
  return replaced(text, *what, text.behind_comma(what->end));
}

namespace {

bool names_new(const EditText& text, std::size_t at) {
  const auto thing = named_thing_at(text, at);
  return !thing || thing->which == NamedThing::Which::indefinite || (thing->bare && fitting(text, *thing).empty());
}

}  // namespace

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

std::optional<Read<std::string>> room_part_at(const EditText& text, std::size_t at) {
  while (at < text.tokens.size() && (text.words.definite.count(text.tokens[at].text) || text.is_word(at, "all"))) ++at;
  const auto part = longest(text.edits.room_parts, text.tokens, at, 2);
  if (!part) return std::nullopt;
  // "the floor lamp"
  if (const auto thing = named_thing_at(text, at); thing && thing->kind.category && thing->end > at + part.length)
    return std::nullopt;
  return Read<std::string>{*part.value, at + part.length};
}

ReadClause recolored(const EditText& text, const Read<Ids>& what, std::size_t at) {
  const auto looks = looks_at(text, at, false);
  if (!looks || !*looks) return what_at(text, at, "no colour or material is known");
  return of_each(what, (*looks)->end, [&](const std::string& id) { return edit::Recolor{id, (*looks)->value}; });
}

ReadClause read_looks_first(const EditText& text, std::size_t at) {
  for (std::size_t i = at + 1; !text.ends(i); ++i) {
    if (!text.is_word(i, "on") && !text.is_word(i, "for")) continue;
    const std::string words = text.words_from(at, i);
    if (!describes_looks(words)) break;
    if (const auto part = room_part_at(text, i + 1))
      return Clause{{edit::Cover{part->value, words, ""}}, {}, {}, part->end};
    const auto what = things(text, i + 1, true);
    if (!what) return what.error();
    return of_each(*what, what->end, [&](const std::string& id) { return edit::Recolor{id, words}; });
  }
  return what_at(text, at, "not understood");
}

ReadClause read_another(const EditText& text, std::size_t at) {
  const auto wanted = substitute_at(text, at);
  if (!wanted || !*wanted || !(*wanted)->value.category.empty()) return what_at(text, at, "not understood");
  return replaced(text, {text.latest, at}, at);
}

namespace {

// "the room", as something to paint, is its walls.
std::optional<Read<std::string>> painted_part_at(const EditText& text, std::size_t at) {
  if (auto part = room_part_at(text, at)) return part;
  const auto whole = longest_in(text.edits.whole_room, text.tokens, at);
  return whole > 0 ? std::optional(Read<std::string>{"walls", at + whole}) : std::nullopt;
}

}  // namespace

ReadClause read_looks(const EditText& text, std::size_t at) {
  if (const auto part = painted_part_at(text, at)) {
    const auto looks = looks_at(text, part->end, true);
    if (looks && *looks) return Clause{{edit::Cover{part->value, (*looks)->value, ""}}, {}, {}, (*looks)->end};
  }
  const auto what = things(text, at, true);
  const auto plain = things(text, at, false);
  for (const auto* read : {&what, &plain}) {
    if (!*read) continue;
    if (auto painted = recolored(text, **read, (*read)->end)) return painted;
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
      const bool is_other = std::string(to) != "to" || (thing && thing->kind.category);
      if (auto other = is_other ? replaced(text, *what, what->end + 1) : ReadClause(not_understood(""));
          goes_to_its_end(text, other))
        return other;
      if (thing && thing->kind.category) return replaced(text, *what, what->end + 1);
      if (auto other = replaced(text, *what, what->end + 1); goes_to_its_end(text, other)) return other;
    }
  }
  return read_looks(text, at);
}

ReadClause read_size(const EditText& text, const Read<Ids>& what, std::size_t at) {
  const auto size = size_at(text, at);
  if (!size) return what_at(text, at, "it is not clear how large");
  if (!*size) return size->error();
  return of_each(what, (*size)->end, [&](const std::string& id) {
    const Object* object = find_object(text.scene, id);
    return edit::Resize{id, resized(object ? object->size : Vec3(Vec3::Ones()), (*size)->value)};
  });
}

namespace {

// "round", "square": another of the kind that has this shape.
ReadClause reshaped(const EditText& text, const Read<Ids>& what, std::size_t at) {
  const auto length = longest_in(text.edits.shapes, text.tokens, at);
  if (length == 0) return what_at(text, at, "not understood");
  return of_each(what, at + length, [&](const std::string& id) {
    const Object* object = text.object(id);
    return edit::Replace{id, "", text.words_from(at, at + length) + " " + (object ? object->category : "")};
  });
}

}  // namespace

namespace {

// "make bigger the rug"
ReadClause read_size_first(const EditText& text, std::size_t at) {
  const auto size = size_at(text, at);
  if (!size || !*size) return what_at(text, at, "not understood");
  const auto what = things(text, (*size)->end, true);
  if (!what) return what.error();
  auto clause = read_size(text, {what->value, at}, at);
  if (clause) clause->end = what->end;
  return clause;
}

}  // namespace

ReadClause read_make(const EditText& text, std::size_t at) {
  const auto what = things(text, at, true);
  if (what) {
    const bool are_there = std::all_of(what->value.begin(), what->value.end(),
                                       [&](const std::string& id) { return find_object(text.scene, id); });
    if (are_there && size_at(text, what->end)) return read_size(text, *what, what->end);
    const auto thing = named_thing_at(text, what->end);
    if (thing && thing->kind.category && thing->which == NamedThing::Which::indefinite)
      return replaced(text, *what, what->end);
    if (auto away = read_facing_away(text, *what)) return *away;
    if (text.is_word(what->end, "face")) {
      const auto target = target_at(text, what->end + 1, what->value);
      if (target && *target)
        return of_each(*what, (*target)->end, [&](const std::string& id) { return edit::Face{id, (*target)->id}; });
    }
  }
  if (what)
    if (auto other = reshaped(text, *what, what->end); goes_to_its_end(text, other)) return other;
  if (auto sized = read_size_first(text, at); goes_to_its_end(text, sized)) return sized;
  if (!what && !painted_part_at(text, at)) return what.error();
  return read_looks(text, at);
}

namespace {

ReadClause resize_each(const EditText& text, const Read<Ids>& what, const NewSize& size) {
  for (const auto& id : what.value)
    if (!find_object(text.scene, id)) return not_understood(id + " is not there yet");
  return of_each(what, what.end, [&](const std::string& id) {
    return edit::Resize{id, resized(find_object(text.scene, id)->size, size)};
  });
}

// A verb that says which way a side changes: "increase", "raise"; those that say none only set it.
double way_of(const EditText& text, const std::string& verb) {
  if (const auto growth = text.edits.verbs_of_size.find(verb); growth != text.edits.verbs_of_size.end())
    return growth->second.factor;
  const auto lift = text.edits.lifts.find(verb);
  return lift == text.edits.lifts.end() ? 1.0 : lift->second > 0 ? 1.2 : 0.8;
}

}  // namespace

std::optional<ReadClause> read_property(const EditText& text, std::size_t at, const std::string& verb) {
  const auto sized = sized_things_at(text, at);
  if (!sized) return std::nullopt;
  const double way = way_of(text, verb);
  if (const auto size = size_behind_verb(text, sized->end, {sized->value.side, way}); size && *size) {
    const bool is_said = (*size)->end > sized->end || way != 1.0;
    if (is_said) return resize_each(text, {sized->value.ids, (*size)->end}, (*size)->value);
  }
  std::size_t end = sized->end;
  const auto metres = length_at(text, end);
  if (!metres || sized->value.side == "all") return what_at(text, sized->end, "it is not clear how large");
  NewSize size{sized->value.side, 0.0, {}, {}};
  size.exact = *metres;
  return resize_each(text, {sized->value.ids, end}, size);
}

ReadClause read_resize(const EditText& text, std::size_t at, const std::string& verb) {
  const auto what = things(text, at, true);
  if (!what) return what.error();
  const auto known = text.edits.verbs_of_size.find(verb);
  if (known == text.edits.verbs_of_size.end()) return read_size(text, *what, what->end);
  const auto size = size_behind_verb(text, what->end, known->second);
  if (!size) return what_at(text, what->end, "it is not clear how large");
  if (!*size) return size->error();
  return resize_each(text, {what->value, (*size)->end}, (*size)->value);
}

}  // namespace roomgen
