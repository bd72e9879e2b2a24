#include <algorithm>

#include "language/inflection.h"
#include "language/lexicon.h"
#include "thing_readers.h"

namespace roomgen::brief {

namespace {

using language::Determiner;
using language::WordClass;

class NameReader : private PhraseWords {
 public:
  NameReader(const PhraseWords& phrase, ThingPhrase& thing) : PhraseWords(phrase), thing_(thing) {}

  void run() {
    known_name();
    other_compound();
    misspelt_name();
    if (thing_.kind.length == 0) inferred_name();
    if (thing_.kind.length == 0) toy_name();
    thing_.name_tokens = {start_, static_cast<std::uint32_t>(std::max<std::size_t>(thing_.end, said.head + 1))};
  }

 private:
  // "a pink plush bunny": no animal.
  void toy_name() {
    static const WordSet stuffs = {"plush", "stuffed", "toy", "cuddly", "crocheted", "knitted", "felt", "foam", "rubber"};
    const std::string noun = in_singular(said.head);
    if (!language::lexicon().is(noun, WordClass::animal)) return;
    for (std::uint32_t i = said.tokens.begin; i < said.head; ++i)
      if (const Kind* kind = stuffs.count(word(i)) ? text.table.named("stuffed animal") : nullptr)
        return take_name(said.head, {kind, NounBasis::hyponym, noun}, noun);
  }
  // The longest name that ends in the head: of "bedside table lamp" that of the lamp.
  void known_name() {
    thing_.end = said.tokens.end;
    start_ = said.head;
    for (std::uint32_t i = said.tokens.begin; i <= said.head; ++i) {
      const KindMention mention = mention_at(text.table, text.plain, i);
      const std::size_t end = i + mention.length;
      const bool goes_on = end > said.head + 1 && text.plain[said.head + 1].is_word("of");
      if (mention.length == 0 || (end != said.head + 1 && !goes_on)) continue;
      thing_.kind = mention;
      thing_.end = std::max(thing_.end, end);
      start_ = i;
      return;
    }
    thing_.noun = parse.head_of(said);
  }
  // "a grab bar", which is none of the bars that the table calls so: English has a word of its own for it.
  void other_compound() {
    if (thing_.kind.length == 0) return;
    for (std::uint32_t i = said.tokens.begin; i < start_; ++i) {
      const std::string noun = in_singular(i);
      if (!is_noun_before(i) || !language::lexicon().has(noun, language::PartOfSpeech::noun)) continue;
      const NounKind meant = inferred_kind(text.table, noun);
      if (!meant.kind || meant.kind == thing_.kind.category || is_of(*meant.kind, thing_.kind.category->name)) return;
      if (meant.basis == NounBasis::hyponym && text.table.named(thing_.kind.name) == text.table.named(meant.name)) return;
      return take_name(i, meant, noun);
    }
  }
  bool is_noun_before(std::uint32_t token) const {
    return std::any_of(parse.modifiers.begin() + said.modifiers.begin, parse.modifiers.begin() + said.modifiers.end,
                       [&](const auto& one) {
                         return one.tokens.begin == token && one.kind == language::Modifier::Kind::noun;
                       });
  }
  // A longer one with a slip in it: "bokshelf", "cofee table".
  void misspelt_name() {
    const std::size_t name_start = thing_.kind.length > 0 ? start_ : said.head + 1;
    for (std::uint32_t i = said.tokens.begin; i < name_start; ++i) {
      const std::string written = text_between(i, said.head);
      const NounKind meant = misspelt_kind(text.table, written);
      if (!meant.kind) continue;
      take_name(i, meant, meant.name);
      thing_.kind.misspelt = written;
      return;
    }
  }
  // "credenza", "gong": nouns that no kind is called by, where something is introduced.
  void inferred_name() {
    if (!is_introduced() || said.is_pronoun || text.words.room_parts.count(thing_.noun)) return;
    for (std::uint32_t i = said.tokens.begin; i <= said.head; ++i) {
      const std::string noun = in_singular(i);
      const bool is_word = language::lexicon().has(noun, language::PartOfSpeech::noun);
      if ((i < said.head && !is_word) || !may_be_thing(text, noun)) continue;
      const NounKind meant = inferred_kind(text.table, noun);
      if (!meant.kind) continue;
      take_name(i, meant, noun);
      if (thing_.kind.is_stand_in()) take_nouns_before();
      return;
    }
  }
  bool is_introduced() const {
    if (said.determiner != Determiner::absent || said.count > 0 || said.is_plural) return true;
    return (said.list != language::none || is_placed()) && !may_be_stuff(thing_.noun) &&
           !language::positive(thing_.noun);
  }
  // "Shredder in the corner."
  bool is_placed() const {
    constexpr double surely = 0.9;
    return language::lexicon().share(thing_.noun, WordClass::artefact) >= surely &&
           std::any_of(parse.attachments.begin(), parse.attachments.end(), [&](const auto& one) {
             return one.from == number && one.to != language::none && one.relation != "of";
           });
  }
  void take_name(std::uint32_t first, const NounKind& meant, const std::string& name) {
    start_ = first;
    thing_.kind = {meant.kind, said.head + 1 - first, said.is_plural, name, meant.basis, ""};
    thing_.end = std::max<std::size_t>(thing_.end, said.head + 1);
    thing_.noun.clear();
  }
  // Of what nobody knows the whole compound is the name: a "gas cylinder".
  void take_nouns_before() {
    while (start_ > said.tokens.begin && names_what_is_behind(start_ - 1)) {
      --start_;
      thing_.kind.name = word(start_) + " " + thing_.kind.name;
      ++thing_.kind.length;
    }
  }
  bool names_what_is_behind(std::uint32_t token) const {
    const auto& english = language::lexicon();
    const std::string& here = word(token);
    return is_modifier(token) && english.has(here, language::PartOfSpeech::noun) &&
           !english.has(here, language::PartOfSpeech::adjective) && !text.words.materials.count(here) &&
           !text.words.sizes.count(here) && !english.may_be(here, WordClass::color);
  }

  ThingPhrase& thing_;
  std::uint32_t start_ = 0;  ///< of the name
};

}  // namespace

void read_name(const PhraseWords& phrase, ThingPhrase& thing) { NameReader(phrase, thing).run(); }

}  // namespace roomgen::brief
