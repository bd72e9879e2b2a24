#include <algorithm>

#include "language/function_word.h"
#include "language/lexicon.h"
#include "scene/finish_words.h"
#include "thing_readers.h"
#include "tone.h"

namespace roomgen::brief {

namespace {

using language::Attachment;
using language::Determiner;
using language::Run;
using language::WordClass;

bool is_bare(const language::NounPhrase& phrase) {
  return phrase.determiner == Determiner::absent && phrase.count == 0 && !phrase.is_pronoun;
}

// "in pale ash", "in rust bouclé": what a thing is in, and that may be a colour or what things are
// made of.
bool may_be_look(const PhraseWords& words, const language::NounPhrase& phrase) {
  for (auto i = phrase.tokens.begin; i <= phrase.head; ++i)
    if (may_be_stuff(words.word(i)) || words.text.words.materials.count(words.word(i))) return true;
  return false;
}

class LookReader : private PhraseWords {
 public:
  LookReader(const PhraseWords& phrase, ThingPhrase& thing) : PhraseWords(phrase), thing_(thing) {}

  void run() {
    modifiers();
    described_elsewhere();
  }

 private:
  void modifiers() {
    joined_looks();
    for (auto i = said.modifiers.begin; i < said.modifiers.end; ++i) {
      const auto& modifier = parse.modifiers[i];
      add_words(modifier.tokens, thing_.name_tokens.begin);
      if (modifier.kind == language::Modifier::Kind::noun && modifier.tokens.end <= thing_.name_tokens.begin &&
          !tells_look(modifier))
        for (auto token = modifier.tokens.begin; token < modifier.tokens.end; ++token)
          if (!names_tone(token)) thing_.naming.push_back(word(token));
    }
  }
  // "a striped navy and white rug": what stands before "and" is no phrase of its own.
  void joined_looks() {
    const std::uint32_t first = said.tokens.begin;
    if (said.determiner != Determiner::absent || first < 2 || !text.plain[first - 1].is_word("and")) return;
    std::uint32_t begin = first - 1;
    while (begin > 0 && finish_words().describes(word(begin - 1))) --begin;
    const bool is_introduced_before = begin > 0 && (is_number(begin - 1) || is_article(begin - 1));
    if (is_introduced_before) add_words({begin, first - 1}, thing_.name_tokens.begin);
  }
  // "oak", "corner", "kitchen": of what it is, or where.
  bool tells_look(const language::Modifier& modifier) const {
    for (auto token = modifier.tokens.begin; token < modifier.tokens.end; ++token) {
      const std::string& noun = word(token);
      if (text.words.materials.count(noun) || text.words.sizes.count(noun) || text.words.parts.count(noun) ||
          text.words.room_parts.count(noun) || text.words.room_words.count(noun) || may_be_stuff(noun) ||
          language::lexicon().is(noun, WordClass::room) || language::lexicon().is(noun, WordClass::shape) ||
          language::lexicon().is(noun, WordClass::person) || text.plain[token].kind != Token::Kind::word)
        return true;
    }
    return false;
  }
  bool names_tone(std::uint32_t i) const {
    return i + 1 < thing_.name_tokens.begin && !language::is_function_word(parse.tokens[i]) && begins_tone(text.plain, i, text.words);
  }
  void add_words(const Run& run, std::size_t before) {
    for (std::uint32_t i = std::max(run.begin, tone_end_); i < std::min<std::size_t>(run.end, before); ++i) {
      if (names_tone(i)) {
        add_modifier(thing_, word(i) + " " + word(i + 1), {i, i + 2});
        tone_end_ = ++i + 1;
        continue;
      }
      if (is_measured(i, thing_)) {
        ++i;
        continue;
      }
      if (const std::size_t length = longest_in(text.words.full_heights, text.plain, i)) {
        thing_.is_full_height = true;
        thing_.measure_tokens.push_back({i, i + static_cast<std::uint32_t>(length)});
        i += static_cast<std::uint32_t>(length) - 1;
        continue;
      }
      // "a single chair"
      if (std::find(thing_.count_tokens.begin(), thing_.count_tokens.end(), i) != thing_.count_tokens.end()) continue;
      if (text.plain[i].is_word("built") && i + 1 < run.end && text.plain[i + 1].is_word("in")) {
        add_modifier(thing_, "built in", {i, i + 2});
        ++i;
      } else if (text.plain[i].kind == Token::Kind::word && !language::is_function_word(parse.tokens[i]) && word(i) != "own") {
        add_modifier(thing_, word(i), {i, i + 1});
      }
    }
  }

  // "the sofa is red", "made of oak", "in blue velvet"
  void described_elsewhere() {
    for (const auto& verb : parse.verbs)
      if (verb.subject == number && !verb.is_denied)
        for (auto i = verb.complement.begin; i < verb.complement.end; ++i)
          if (!parse.modifiers[i].is_denied)
            add_words(parse.modifiers[i].tokens, text.plain.size());
    for (const auto& attachment : parse.attachments)
      if (attachment.from == number && !attachment.is_denied && tells_material(*this, attachment)) {
        const auto& material = parse.phrases[static_cast<std::size_t>(attachment.to)];
        add_words({material.tokens.begin, material.head + 1}, text.plain.size());
      }
  }

  ThingPhrase& thing_;
  std::uint32_t tone_end_ = 0;  ///< up to where colours of two words were read
};

}  // namespace

bool tells_material(const PhraseWords& phrase, const Attachment& attachment) {
  if (attachment.is_verb || attachment.to == language::none) return false;
  // "a desk and two armchairs, all in green": what the whole list is in, the room is.
  const auto begin = attachment.tokens.begin;
  if (phrase.said.list != language::none && begin > 0 && phrase.word(begin - 1) == "all")
    return false;
  static const WordSet relations = {"of", "in", "from"};
  const auto& to = phrase.parse.phrases[static_cast<std::size_t>(attachment.to)];
  const std::string& noun = phrase.word(to.head);
  if (!relations.count(attachment.relation) || !is_bare(to)) return false;
  if (phrase.text.words.materials.count(noun) || language::lexicon().is(noun, WordClass::color) ||
      (language::lexicon().is(noun, WordClass::material) && !to.is_plural))
    return true;
  return attachment.relation == "in" && !to.is_plural && may_be_look(phrase, to);
}

void read_looks(const PhraseWords& phrase, ThingPhrase& thing) { LookReader(phrase, thing).run(); }

}  // namespace roomgen::brief
