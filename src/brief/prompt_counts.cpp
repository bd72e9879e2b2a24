#include <algorithm>

#include "phrase_readers.h"

namespace roomgen::brief {

namespace {

using language::Attachment;
using language::Determiner;
using language::none;
using language::NounPhrase;

// "3 of those recliners", which nothing was said of before
bool counts_new(const PromptReading& reading, std::int32_t id, const NounPhrase& number, std::size_t mention) {
  return number.is_pronoun && number.count >= 1 && !reading.talk.mention(mention).counted &&
         mention + 1 == reading.talk.count() && reading.phrase(id).is_plural;
}

bool is_had_by_each(const PromptReading& reading, std::int32_t id) {
  return std::any_of(reading.parse.attachments.begin(), reading.parse.attachments.end(), [&](const Attachment& one) {
    return one.to == id && one.from != none && reading.owns(one) && reading.phrase(one.from).is_pronoun &&
           reading.phrase(one.from).determiner == Determiner::each && !reading.mention_of(one.from);
  });
}

// "three rows of five seats"
void read_rows(PromptReading& reading, std::int32_t id, std::size_t mention) {
  for (const Attachment& attachment : reading.parse.attachments) {
    if (attachment.to != id || attachment.relation != "of" || attachment.from == none) continue;
    const NounPhrase& rows = reading.phrase(attachment.from);
    if (counts_new(reading, id, rows, mention)) {
      reading.talk.set_count(mention, static_cast<int>(rows.count));
      reading.hearing.number(attachment.from, mention);
    }
    if (!reading.words.groups.count(reading.word(rows.head))) continue;
    reading.mentions[static_cast<std::size_t>(attachment.from)] = mention;
    if (rows.count > 1 && reading.phrase(id).count > 0)
      reading.talk.multiply(mention, static_cast<int>(rows.count));
    reading.hearing.number(attachment.from, mention);
  }
}

// "three toddlers nap in their own cots", "four flatmates: each has a bin": as many as there are of them.
void one_for_each_person(PromptReading& reading, std::int32_t id, std::size_t mention) {
  const NounPhrase& said = reading.phrase(id);
  const bool is_own = said.determiner == Determiner::possessive && said.is_plural && said.head > said.tokens.begin &&
                      reading.is_word(said.tokens.begin + 1, "own");
  if (!is_own && !is_had_by_each(reading, id)) return;
  for (std::int32_t i = id; i-- > 0;) {
    const NounPhrase& before = reading.phrase(i);
    if (before.count < 2 || before.is_pronoun || reading.mention_of(i) || !reading.is_somebody(before)) continue;
    if (before.count > most_of_them) return;
    reading.talk.set_count(mention, static_cast<int>(before.count));
    return reading.hearing.number({said.tokens.begin, said.tokens.begin + (is_own ? 2u : 1u)}, mention);
  }
}

}  // namespace

void read_counts(PromptReading& reading, std::int32_t phrase, std::size_t mention) {
  read_rows(reading, phrase, mention);
  one_for_each_person(reading, phrase, mention);
}

}  // namespace roomgen::brief
