#include "prompt_reading.h"

#include <algorithm>

#include "language/inflection.h"
#include "language/lexicon.h"
#include "scene/finish_words.h"

namespace roomgen::brief {

namespace {

// Whether words that say where something is said it of anything: "in winter" does not.
bool is_said_of_anything(const Brief& brief, std::size_t heard) {
  const auto says = [&](const auto& one) { return one.heard == heard; };
  if (std::any_of(brief.denials.begin(), brief.denials.end(), says) || std::any_of(brief.shared_out.begin(), brief.shared_out.end(), says))
    return true;
  return std::any_of(brief.mentions.begin(), brief.mentions.end(), [&](const Mention& mention) {
    return mention.mount_heard == heard || mention.formation_heard == heard ||
           std::any_of(mention.demands.begin(), mention.demands.end(),
                       [&](const Demand& demand) { return demand.heard == heard; });
  });
}

}  // namespace

using language::Attachment;
using language::none;
using language::Run;

std::vector<Taken> taken_from(std::size_t count, const std::vector<Token>& left) {
  std::vector<Taken> taken(count, Taken::yes);
  for (const Token& token : left)
    for (auto i = token.source.begin; i < token.source.end; ++i)
      taken[i] = token.kind == Token::Kind::room ? Taken::room : Taken::no;
  return taken;
}

PromptReading::PromptReading(const PromptText& said, std::vector<Token> untaken,
                             std::vector<Taken> already, const Lexicon& names,
                             const RoomKinds& rooms, Brief& result)
    : text(said),
      parse(said.parse),
      kinds(rooms),
      left(std::move(untaken)),
      taken(std::move(already)),
      words(names.words),
      brief(result),
      lexicon(names),
      talk(names, result),
      hearing(said, result),
      mentions(parse.phrases.size()),
      also(parse.phrases.size()),
      is_share(parse.phrases.size(), false) {
  for (std::size_t i = 0; i < parse.phrases.size(); ++i)
    things.push_back(read_thing_phrase(text, i));
  for (const auto& attachment : parse.attachments)
    placements.push_back(placement_of(text, attachment));
}

bool PromptReading::is_somebody(const language::NounPhrase& phrase) const {
  using language::WordClass;
  const std::string noun = language::singular(word(phrase.head));
  const auto& english = language::lexicon();
  if (finish_words().describes(noun) || kinds.style(noun)) return false;  // "in blue and white", "minimalist"
  return english.is(noun, WordClass::person) || english.is(noun, WordClass::animal);
}

int PromptReading::sentence_of(std::size_t token) const {
  const auto sentence =
      std::upper_bound(parse.sentences.begin(), parse.sentences.end(), token,
                       [](std::size_t one, const Run& said) { return one < said.end; });
  return static_cast<int>(sentence - parse.sentences.begin());
}

bool PromptReading::announces(const Run& sentence) const {
  if (sentence.empty()) return false;
  const auto& last = parse.tokens[sentence.end - 1];
  return last.kind == language::Token::Kind::stop && last.text == ":";
}

bool PromptReading::is_denied(std::size_t token) const {
  for (std::size_t n = 1; n <= 2 && n <= token; ++n)
    if (words.negations.count(word(token - n)) || is_word(token - n, "nothing")) return true;
  return false;
}

std::vector<bool> PromptReading::heard_tokens() const {
  std::vector<bool> used(text.plain.size(), false);
  for (const auto& heard : brief.heard)
    std::fill(used.begin() + heard.tokens.begin,
              used.begin() + std::min<std::ptrdiff_t>(heard.tokens.end, std::ssize(used)), true);
  return used;
}

std::vector<bool> PromptReading::tokens_with_sense() const {
  std::vector<bool> used(text.plain.size(), false);
  for (std::size_t i = 0; i < brief.heard.size(); ++i) {
    const HeardWords& heard = brief.heard[i];
    if (heard.as == Heard::As::relation && !is_said_of_anything(brief, i)) continue;
    for (auto token = heard.tokens.begin; token < heard.tokens.end && token < used.size(); ++token) used[token] = true;
  }
  return used;
}

void PromptReading::look_back_from(std::size_t token) {
  std::size_t made = 0, next = talk.count();
  std::vector<bool> is_named_before(talk.count(), false);
  for (std::size_t i = 0; i < parse.phrases.size(); ++i) {
    if (!mentions[i]) continue;
    const bool is_before = parse.phrases[i].head < token;
    if (is_before) is_named_before[*mentions[i]] = true;
    if (talk.mention(*mentions[i]).part_of != Demand::none) continue;
    if (is_before)
      made = std::max(made, *mentions[i] + 1);
    else if (!is_named_before[*mentions[i]])
      next = std::min(next, *mentions[i]);
  }
  talk.look_back_from(std::min(made, next));
}

Indices PromptReading::named_before(std::size_t token) const {
  Indices things;
  for (std::size_t i = 0; i < parse.phrases.size(); ++i) {
    const std::size_t head = parse.phrases[i].head;
    if (head < token && mentions[i] && sentence_of(head) == sentence_of(token)) things.push_back(*mentions[i]);
  }
  return things;
}

bool PromptReading::owns(const Attachment& attachment) const {
  static const WordSet relations = {"with", "have", "feature", "include"};
  return relations.count(attachment.relation) > 0;
}

Indices PromptReading::subjects_of(const Attachment& attachment) const {
  const Attachment& said = of_thing(attachment);
  if (said.from == none) return {};
  if (said.is_of_list) return mentions_of_list(said.from);
  return all_of(said.from);
}

Indices PromptReading::all_of(std::int32_t phrase) const {
  const auto mention = mention_of(phrase);
  if (!mention) return {};
  Indices all = means_some(phrase) ? Indices{*mention} : talk.with_parts(*mention);
  for (const std::size_t further : also[static_cast<std::size_t>(phrase)])
    if (!is_among(all, further)) all.push_back(further);
  return all;
}

std::optional<std::size_t> PromptReading::joined_before(std::int32_t id) const {
  const auto begin = phrase(id).tokens.begin;
  if (id == 0 || begin == 0 || !is_word(begin - 1, "and")) return std::nullopt;
  const language::NounPhrase& before = phrase(id - 1);
  return before.tokens.end + 1 == begin && before.list == phrase(id).list && before.list != none ? mention_of(id - 1) : std::nullopt;
}

bool PromptReading::is_told_at_pronoun(std::int32_t phrase_number) const {
  return std::any_of(parse.attachments.begin(), parse.attachments.end(), [&](const Attachment& one) {
    return one.from == phrase_number && one.to != none && phrase(one.to).is_pronoun && placement(one);
  });
}

// "a cabinet with glass doors"
bool PromptReading::is_part_of_thing(const Attachment& with) const {
  return with.to != none && phrase(with.to).list == none && mention_of(with.from) && words.parts.count(word(phrase(with.to).head));
}

// "in the corner next to the door": what is said of a place is said of what is there.
const Attachment& PromptReading::of_thing(const Attachment& attachment) const {
  const Attachment* said = &attachment;
  for (int steps = 0; steps < 4 && said->from != none && !mention_of(said->from); ++steps) {
    const auto to_place =
        std::find_if(parse.attachments.begin(), parse.attachments.end(), [&](const Attachment& one) {
          return one.to == said->from && one.relation != "of" && (!owns(one) || is_part_of_thing(one));
        });
    if (to_place == parse.attachments.end()) break;
    said = &*to_place;
  }
  return *said;
}

Indices PromptReading::mentions_of_list(std::int32_t phrase) const {
  Indices subjects;
  for (const auto one : parse.with_list(static_cast<std::uint32_t>(phrase)))
    for (const std::size_t mention : all_of(static_cast<std::int32_t>(one)))
      if (!is_among(subjects, mention)) subjects.push_back(mention);
  return subjects;
}

}  // namespace roomgen::brief
