#include <algorithm>

#include "phrase_readers.h"
#include "prompt_passes.h"
#include "roomgen/base/text.h"
#include "scene/finish_words.h"

namespace roomgen::brief {

namespace {

using language::Attachment;
using language::Determiner;
using language::none;
using language::NounPhrase;

// "nobody needs desks"
bool is_of_nobody(const PromptReading& reading, std::int32_t id) {
  return std::any_of(reading.parse.verbs.begin(), reading.parse.verbs.end(), [&](const language::VerbPhrase& verb) {
    return verb.object == id && verb.subject != none && reading.is_word(reading.phrase(verb.subject).head, "nobody");
  });
}

// "not next to the sofa": the sofa is there.
bool is_denied_place(const PromptReading& reading, std::int32_t id) {
  return reading.phrase(id).determiner == Determiner::definite &&
         std::any_of(reading.parse.attachments.begin(), reading.parse.attachments.end(),
                     [&](const Attachment& one) { return one.to == id && one.is_denied && reading.placement(one); });
}

// "half of them without mattresses": the others have some.
bool is_of_some(const PromptReading& reading, std::int32_t id) {
  return std::any_of(reading.parse.attachments.begin(), reading.parse.attachments.end(), [&](const Attachment& one) {
    return one.to == id && one.is_denied && one.from != none && reading.phrase(one.from).is_pronoun && reading.phrase(one.from).count > 0;
  });
}

// "no pink", "no red things": no thing shall look so.
bool exclude_look(PromptReading& reading, std::int32_t id, const ThingPhrase& thing) {
  static const WordSet of_nothing = {"colour", "colours", "color", "colors", "whatsoever"};
  const NounPhrase& said = reading.phrase(id);
  const std::string& noun = reading.word(said.head);
  if (thing.kind.length > 0 && !thing.kind.is_inferred()) return false;
  std::vector<std::string> looks;
  for (auto i = said.tokens.begin; i <= said.head; ++i)
    if (finish_words().describes(reading.word(i))) looks.push_back(reading.word(i));
  if (looks.empty() || !(finish_words().describes(noun) || of_nothing.count(noun) || reading.words.anything.count(noun)))
    return false;
  const std::string look = join(looks, " ");
  reading.hearing.absence(id, look);
  reading.brief.excluded_looks.push_back({"", look});
  return true;
}

void forbid(PromptReading& reading, const std::string& category) {
  auto& excluded = reading.brief.excluded;
  if (std::find(excluded.begin(), excluded.end(), category) == excluded.end()) excluded.push_back(category);
}

bool is_closed_compound_of(const std::string& name, const std::string& noun) {
  return name.size() > noun.size() && name.ends_with(noun) && name.find(' ') == std::string::npos;
}

void exclude(PromptReading& reading, std::int32_t id, const ThingPhrase& thing) {
  if (denies_others(reading, reading.phrase(id))) return;
  const std::string& noun = reading.word(reading.phrase(id).head);
  if (noun == "window" || noun == "windows") {
    reading.brief.windows = 0;
    reading.hearing.absence(id, "window");
  }
  const bool is_named = thing.kind.length > 0, is_known = is_named && !thing.kind.is_stand_in();
  if (!is_named && !may_be_thing(reading.text, thing.noun)) return;
  const std::string& unknown = is_named ? thing.kind.name : thing.noun;
  const std::string category = is_known ? thing.kind.category->name : unknown;
  // "avoid glass tables" forbids no tables.
  if (is_known && !thing.modifiers.empty()) {
    const std::string looks = join(thing.modifiers, " ");
    reading.hearing.absence(id, looks + " " + category);
    reading.brief.excluded_looks.push_back({category, looks});
    return;
  }
  reading.hearing.absence(id, category);
  forbid(reading, category);
  // Who wants no chairs wants no armchairs.
  const std::string& parent = reading.text.table.get(category).parent;
  for (const auto& [name, kind] : reading.text.table.all())
    if (kind.parent == parent && !parent.empty() && is_closed_compound_of(name, category)) forbid(reading, name);
}

}  // namespace

bool read_exclusion(PromptReading& reading, std::int32_t phrase, const ThingPhrase& thing) {
  if (!reading.phrase(phrase).is_denied && !is_of_nobody(reading, phrase)) return false;
  if (exclude_look(reading, phrase, thing)) return true;
  if (is_denied_place(reading, phrase)) return false;
  if (is_of_some(reading, phrase)) {
    const NounPhrase& said = reading.phrase(phrase);
    hear(reading.brief, {said.tokens.begin, said.head + 1}, Heard::As::not_understood);
    return true;
  }
  exclude(reading, phrase, thing);
  return true;
}

}  // namespace roomgen::brief
