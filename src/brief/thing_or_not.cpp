#include "thing_or_not.h"

#include <algorithm>

#include "language/inflection.h"
#include "language/lexicon.h"
#include "scene/finish_words.h"

namespace roomgen::brief {

using language::Attachment;
using language::Determiner;
using language::none;
using language::NounPhrase;

// "a stack of books": what comes behind is part of the name.
bool ThingOrNot::names_thing(std::int32_t id, const ThingPhrase& thing) const {
  const NounPhrase& said = reading_.phrase(id);
  if (gives_reason(said) || names_tone(said, thing) || is_talked_about(id) || is_formation(id) ||
      is_handled(id) || is_who_it_is_for(id))
    return false;
  if (thing.kind.length == 0)
    return is_new_thing(id, thing) || (thing.definite && reading_.talk.known(thing));
  if (thing.kind.length == 1 && (is_bare_material(thing) || is_light(said, thing))) return false;
  return !is_of_owner(id, thing) && !is_inside(id) && !tells_what_it_is_of(id, thing);
}

std::optional<std::size_t> ThingOrNot::owner_of_part(std::int32_t id, const ThingPhrase& thing) const {
  for (const Attachment& attachment : reading_.parse.attachments) {
    if (attachment.to != id || !reading_.owns(attachment)) continue;
    const auto owner = reading_.mention_of(attachment.from);
    if (!owner) continue;
    if (is_built_in(thing)) return owner;
    if (reading_.words.parts.count(reading_.word(reading_.phrase(id).head)) &&
        !is_listed_with_thing(attachment))
      return owner;
    if (thing.kind.length > 0 && thing.kind.category->mount == Mount::wall &&
        reading_.talk.mention(*owner).mount == Mount::surface)
      return owner;
  }
  return std::nullopt;
}

// "bangs a hammer": neither a verb of how things stand or look, nor one in the passive.
bool ThingOrNot::does_something(const language::VerbPhrase& verb) const {
  const std::string& word = reading_.word(verb.tokens.end - 1);
  return verb.object != none && verb.kind == language::VerbPhrase::Kind::finite && !verb.is_passive &&
         !reading_.words.verbs.count(word) && !reading_.words.stops.count(word) && !reading_.words.placements.count(word);
}

// "because I have run out of shelves": up to the mark before.
bool ThingOrNot::gives_reason(const NounPhrase& said) const {
  for (std::uint32_t i = said.tokens.begin; i-- > 0;) {
    const auto kind = reading_.text.plain[i].kind;
    if (reading_.is_word(i, "because")) return true;
    if (kind == Token::Kind::comma || kind == Token::Kind::stop) return false;
  }
  return false;
}

// "a podcast studio for four speakers", "a conservatory for painting"
bool ThingOrNot::is_who_it_is_for(std::int32_t id) const {
  const NounPhrase& said = reading_.phrase(id);
  const auto verb = language::verb(reading_.word(said.head));
  const bool is_deed = verb && verb->form == language::VerbForm::gerund && said.tokens.size() == 1;
  if (!is_deed && !language::lexicon().may_be(reading_.parse.head_of(said), language::WordClass::person)) return false;
  return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(), [&](const Attachment& one) {
    return one.to == id && one.relation == "for" && one.from != none && reading_.is_room(reading_.phrase(one.from));
  });
}

// "in two columns of four"
bool ThingOrNot::is_formation(std::int32_t id) const {
  const std::string& noun = reading_.word(reading_.phrase(id).head);
  const bool is_row = reading_.words.rows.count(noun) > 0;
  const auto shape = reading_.words.round_formations.find(noun);
  const bool is_island = shape != reading_.words.round_formations.end() && shape->second.shape == Formation::Shape::islands;
  if (!is_row && !is_island && !reading_.words.groups.count(noun)) return false;
  return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(), [&](const Attachment& one) {
    if (one.from == id && one.relation == "of") return is_row || is_number(one.to) || (is_island && reading_.phrase(one.to).count > 0);
    return one.to == id && one.relation == "in" && is_row;
  });
}

// "blocks of four"
bool ThingOrNot::is_number(std::int32_t id) const {
  return id != none && reading_.phrase(id).is_pronoun && reading_.phrase(id).count > 0;
}

// "relatives who argue about football", "light strips like a racing grid", "if I see a desk"
bool ThingOrNot::is_talked_about(std::int32_t id) const {
  for (auto i = reading_.phrase(id).tokens.begin; i-- > 0 && reading_.text.plain[i].kind == Token::Kind::word;)
    if (reading_.is_word(i, "if")) return true;
  return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(),
                     [&](const Attachment& one) {
                       return one.to == id && (one.relation == "about" || one.relation == "like");
                     });
}

// "kids drop scooters", "an intern distributes pizza": told of what people do, no thing of the room.
bool ThingOrNot::is_handled(std::int32_t id) const {
  const NounPhrase& said = reading_.phrase(id);
  if (said.determiner != Determiner::absent || said.count > 0 || said.is_pronoun) return false;
  return std::any_of(reading_.parse.verbs.begin(), reading_.parse.verbs.end(), [&](const auto& verb) {
    return verb.object == id && verb.subject != none && does_something(verb) && !reading_.words.asking.count(verb.base) &&
           !reading_.phrase(verb.subject).is_pronoun && !reading_.mention_of(verb.subject) &&
           reading_.is_somebody(reading_.phrase(verb.subject));
  });
}

// "bottle green", "oatmeal", without an article: what something looks like.
bool ThingOrNot::names_tone(const NounPhrase& said, const ThingPhrase& thing) const {
  if (thing.article || thing.definite || thing.kind.plural || said.is_plural) return false;
  for (auto i = said.tokens.begin; i <= said.head; ++i)
    if (!finish_words().describes(reading_.word(i))) return false;
  return true;
}

// "glass" alone, without an article, is what something is made of, and "the glass" of which nothing was said before
// is a pane.
bool ThingOrNot::is_bare_material(const ThingPhrase& thing) const {
  return !thing.article && !(thing.definite && reading_.talk.known(thing)) && !thing.kind.plural &&
         reading_.words.materials.count(thing.kind.name) > 0;
}

// "soft light filters through": no lamp.
bool ThingOrNot::is_light(const NounPhrase& said, const ThingPhrase& thing) const {
  return reading_.word(said.head) == "light" && !thing.article && !thing.definite;
}

// A noun that nobody knows is a thing where things are introduced.
bool ThingOrNot::is_new_thing(std::int32_t id, const ThingPhrase& thing) const {
  const NounPhrase& said = reading_.phrase(id);
  const bool introduced = thing.article || (said.list != none && !may_be_stuff(thing.noun)) || begins_with_place(id);
  const bool names_thing = may_be_thing(reading_.text, thing.noun) && is_physical(thing.noun);
  if (!introduced || (thing.definite && !thing.article) || !(names_thing || may_stand_there(id, thing.noun)) ||
      reading_.text.words.room_parts.count(thing.noun) || is_of_owner(id, thing) || is_inside(id))
    return false;
  for (const Attachment& attachment : reading_.parse.attachments)
    if (attachment.to == id && !introduces(attachment)) return false;
  return true;
}

// "..., neon sign over the couch": in the manner of notes, where a segment begins with it and says where it is.
bool ThingOrNot::begins_with_place(std::int32_t id) const {
  const NounPhrase& said = reading_.phrase(id);
  if (said.determiner != Determiner::absent || said.tokens.begin == 0 ||
      reading_.text.plain[said.tokens.begin - 1].kind == Token::Kind::word)
    return false;
  return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(), [&](const Attachment& one) {
    const auto& place = reading_.placement(one);
    return one.from == id && one.tokens.begin == said.head + 1 && place && !place->placement->inverse && place->target != none;
  });
}

// "a branch in a vase", "a shelf holding a dollhouse miniature": whatever its noun means else, it is a thing where
// it is put to one.
bool ThingOrNot::may_stand_there(std::int32_t id, const std::string& noun) const {
  const Vocabulary& words = reading_.words;
  if (noun.size() < 3 || words.no_things.count(noun) || words.parts.count(noun) || words.portions.count(noun) ||
      words.room_words.count(noun) || words.groups.count(noun) || words.shares.count(noun) ||
      words.walls.count(noun) || words.stops.count(noun) || words.placements.count(noun))
    return false;
  using language::WordClass;
  const auto& english = language::lexicon();
  for (const auto other : {WordClass::person, WordClass::animal, WordClass::activity, WordClass::time, WordClass::feeling,
                           WordClass::event, WordClass::room, WordClass::building, WordClass::body_part})
    if (english.is(noun, other) && !english.may_be(noun, WordClass::artefact)) return false;
  return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(), [&](const Attachment& one) {
    const auto& said = reading_.placement(one);
    if (!said || one.to == none) return false;
    if (one.to == id) return said->placement->inverse && reading_.mention_of(one.from);
    return one.from == id && !said->placement->inverse && said->target != none &&
           (reading_.thing(said->target).kind.length > 0 || reading_.phrase(said->target).is_pronoun);
  });
}

bool ThingOrNot::names_artefact(const std::string& noun) {
  using language::WordClass;
  const auto& lexicon = language::lexicon();
  const std::string word = language::singular(noun);
  return lexicon.is(word, WordClass::artefact) && !lexicon.is(word, WordClass::building) &&
         !lexicon.is(word, WordClass::room) && !lexicon.is(word, WordClass::place);
}

bool ThingOrNot::introduces(const Attachment& attachment) const {
  static const WordSet relations = {"with",    "have", "contain", "include",
                                    "feature", "hold", "display", "support",
                                    "carry",   "by",   "need",    "want"};
  if (relations.count(attachment.relation)) return true;
  const auto said = reading_.placement(attachment);
  if (!said) return false;
  // "on an altar", but not "at an angle"
  return said->placement->inverse ||
         names_artefact(reading_.word(reading_.phrase(attachment.to).head));
}

// What is inside something, of what it is made: no thing beside it.
bool ThingOrNot::is_inside(std::int32_t id) const {
  const NounPhrase& said = reading_.phrase(id);
  if (said.determiner != Determiner::absent || said.count > 0) return false;
  for (const Attachment& attachment : reading_.parse.attachments)
    if (attachment.to == id && attachment.relation == "of" && names_owner(attachment.from))
      return true;
  return false;
}

// "a collection of books" are books, "a jar of honey" is a jar.
bool ThingOrNot::names_owner(std::int32_t id) const { return reading_.thing(id).kind.length > 0; }

// "walls of brick", "in leather"
bool ThingOrNot::tells_what_it_is_of(std::int32_t id, const ThingPhrase& thing) const {
  if (!reading_.words.materials.count(reading_.word(reading_.phrase(id).head)) || thing.article ||
      thing.definite)
    return false;
  return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(),
                     [&](const Attachment& one) {
                       return one.to == id && (one.relation == "of" || one.relation == "in");
                     });
}

// "a desk with drawers", "with an integrated sink", "a photo frame with a print": no other thing.
bool ThingOrNot::is_of_owner(std::int32_t id, const ThingPhrase& thing) const {
  return is_built_in(thing) || owner_of_part(id, thing).has_value();
}

bool ThingOrNot::is_built_in(const ThingPhrase& thing) const {
  return std::any_of(thing.modifiers.begin(), thing.modifiers.end(), [&](const auto& modifier) {
    return reading_.words.built_in.count(modifier) > 0;
  });
}

// "with a cabinet and a shelf": a shelf beside other things is one.
bool ThingOrNot::is_listed_with_thing(const Attachment& attachment) const {
  return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(),
                     [&](const Attachment& other) {
                       return other.from == attachment.from &&
                              other.tokens == attachment.tokens && other.to < attachment.to &&
                              reading_.mention_of(other.to);
                     });
}

}  // namespace roomgen::brief
