#include "thing_phrase.h"

#include <algorithm>

#include "language/lexicon.h"
#include "phrase_words.h"
#include "thing_readers.h"

namespace roomgen::brief {

namespace {

using language::Determiner;
using language::WordClass;

// "a jar of honey": bare nouns say what is in it, and are no things beside it.
void read_contents(const PhraseWords& phrase, ThingPhrase& thing) {
  const bool is_told = thing.end > phrase.said.tokens.end;  // "a loaf of bread"
  if (thing.kind.plural || !thing.article || is_told) return;
  for (const auto& attachment : phrase.parse.attachments) {
    if (attachment.from != phrase.number || attachment.relation != "of" || tells_material(phrase, attachment))
      continue;
    const auto& inside = phrase.parse.phrases[static_cast<std::size_t>(attachment.to)];
    if (inside.determiner != Determiner::absent || inside.count > 0 || inside.is_pronoun ||
        phrase.text.words.room_parts.count(phrase.word(inside.head)))
      continue;
    thing.contents = "of";
    thing.contents_tokens = inside.tokens;
    for (auto i = inside.tokens.begin; i < inside.tokens.end; ++i)
      thing.contents += " " + phrase.word(i);
    return;
  }
}

// "headphones", "a pair of scissors"; "six pairs of boots" are six of what is called a pair of boots.
void pair_is_one(const PhraseWords& phrase, ThingPhrase& thing) {
  const auto head = phrase.said.head;
  const bool is_one = phrase.text.words.pairs.count(phrase.word(head)) > 0;
  if (is_one) {
    thing.kind.plural = false;
    if (thing.set || !thing.counted) thing.count = 1;
    thing.article = true;
  }
  const bool is_called_pair = thing.kind.name.starts_with("pair of ") && thing.counted;
  const bool are_pairs = is_called_pair || (is_one && head >= 2 && phrase.word(head - 2) == "pairs");
  if (are_pairs) thing.count = std::max(1, thing.count / 2);
}

// "A case" is rather an event, yet it may be what holds a guitar.
bool may_yet_stand_in_room(const std::string& noun) {
  const auto& english = language::lexicon();
  if (english.is(noun, WordClass::person) || english.is(noun, WordClass::animal)) return false;
  for (const auto thing : {WordClass::furnishing, WordClass::furniture, WordClass::container,
                           WordClass::appliance, WordClass::fixture, WordClass::toy})
    if (english.may_be(noun, thing)) return true;
  return false;
}

}  // namespace

ThingPhrase read_thing_phrase(const PromptText& text, std::size_t phrase) {
  const PhraseWords words(text, phrase);
  ThingPhrase thing;
  read_name(words, thing);
  read_number(words, thing);
  read_looks(words, thing);
  read_contents(words, thing);
  read_lengths(words, thing);
  pair_is_one(words, thing);
  return thing;
}

bool may_be_stuff(const std::string& noun) {
  const auto& english = language::lexicon();
  return english.may_be(noun, WordClass::substance) || english.may_be(noun, WordClass::material) ||
         english.may_be(noun, WordClass::color);
}

bool may_be_thing(const PromptText& text, const std::string& noun) {
  const Vocabulary& words = text.words;
  if (noun.size() < 3 || words.no_things.count(noun) || words.parts.count(noun) ||
      words.sizes.count(noun) || words.room_words.count(noun) || words.people_words.count(noun) ||
      words.people.count(noun) || words.stops.count(noun) || words.verbs.count(noun))
    return false;
  // People, animals, what they do, and when, are no things, nor is what one cannot touch.
  const auto& english = language::lexicon();
  for (const auto no_thing :
       {WordClass::person, WordClass::activity, WordClass::time, WordClass::feeling,
        WordClass::event, WordClass::attribute, WordClass::quantity, WordClass::place,
        WordClass::room, WordClass::color, WordClass::group, WordClass::animal})
    if (english.is(noun, no_thing)) return may_yet_stand_in_room(noun);
  return true;
}

}  // namespace roomgen::brief
