#include "thing_phrase.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "language/amount.h"
#include "language/function_word.h"
#include "language/inflection.h"
#include "language/lexicon.h"
#include "scene/finish_words.h"

namespace roomgen::design {

namespace {

using language::Attachment;
using language::Determiner;
using language::Parse;
using language::Run;
using language::WordClass;

constexpr int max_count = 200;

class ThingPhraseReader {
 public:
  ThingPhraseReader(const PromptText& text, std::size_t number)
      : text_(text),
        parse_(text.parse),
        number_(static_cast<std::int32_t>(number)),
        said_(parse_.phrases[number]) {}

  ThingPhrase run() {
    name();
    count();
    modifiers();
    described_elsewhere();
    contents();
    phrase_.name_tokens = {static_cast<std::uint32_t>(start_),
                           static_cast<std::uint32_t>(std::max<std::size_t>(phrase_.end, said_.head + 1))};
    measures();
    pair_is_one();
    return phrase_;
  }

 private:
  const std::string& word(std::size_t token) const { return text_.plain[token].text; }
  bool is_number(std::size_t token) const {
    return text_.plain[token].kind == Token::Kind::number || text_.words.numbers.count(word(token));
  }
  // "three-drawer", "six seater": no count of things.
  bool is_measured(std::size_t token) const {
    const bool is_name = phrase_.kind.length > 0 && token + 1 == start_;  // "three light stands"
    const bool is_article = word(token) == "a" || word(token) == "an";    // "a shelf" is one
    return is_number(token) && !is_name && !is_article && token < said_.head &&
           text_.words.measured.count(word(token + 1)) > 0;
  }

  void name() {
    known_name();
    other_compound();
    misspelt_name();
    if (phrase_.kind.length == 0) inferred_name();
    if (phrase_.kind.length == 0) toy_name();
  }
  // "a pink plush bunny": no animal.
  void toy_name() {
    static const WordSet stuffs = {"plush", "stuffed", "toy", "cuddly", "crocheted", "knitted", "felt", "foam", "rubber"};
    const std::string noun = in_singular(said_.head);
    if (!language::lexicon().is(noun, WordClass::animal)) return;
    for (std::uint32_t i = said_.tokens.begin; i < said_.head; ++i)
      if (const Kind* kind = stuffs.count(word(i)) ? text_.table.named("stuffed animal") : nullptr)
        return take_name(said_.head, {kind, NounBasis::hyponym, noun}, noun);
  }
  // The longest name that ends in the head: of "bedside table lamp" that of the lamp.
  void known_name() {
    phrase_.end = said_.tokens.end;
    start_ = said_.head;
    for (std::size_t i = said_.tokens.begin; i <= said_.head; ++i) {
      const KindMention mention = mention_at(text_.table, text_.plain, i);
      const std::size_t end = i + mention.length;
      const bool goes_on = end > said_.head + 1 && text_.plain[said_.head + 1].is_word("of");
      if (mention.length == 0 || (end != said_.head + 1 && !goes_on)) continue;
      phrase_.kind = mention;
      phrase_.end = std::max(phrase_.end, end);
      start_ = i;
      return;
    }
    phrase_.noun = parse_.head_of(said_);
  }
  // "a grab bar", which is none of the bars that the table calls so: English has a word of its own for it.
  void other_compound() {
    if (phrase_.kind.length == 0) return;
    for (std::uint32_t i = said_.tokens.begin; i < start_; ++i) {
      const std::string noun = in_singular(i);
      if (!is_noun_before(i) || !language::lexicon().has(noun, language::PartOfSpeech::noun)) continue;
      const NounKind meant = inferred_kind(text_.table, noun);
      if (!meant.kind || meant.kind == phrase_.kind.category || is_of(*meant.kind, phrase_.kind.category->name)) return;
      if (meant.basis == NounBasis::hyponym && text_.table.named(phrase_.kind.name) == text_.table.named(meant.name)) return;
      return take_name(i, meant, noun);
    }
  }
  bool is_noun_before(std::uint32_t token) const {
    return std::any_of(parse_.modifiers.begin() + said_.modifiers.begin, parse_.modifiers.begin() + said_.modifiers.end,
                       [&](const auto& one) {
                         return one.tokens.begin == token && one.kind == language::Modifier::Kind::noun;
                       });
  }
  // A longer one with a slip in it: "bokshelf", "cofee table".
  void misspelt_name() {
    const std::size_t name_start = phrase_.kind.length > 0 ? start_ : said_.head + 1;
    for (std::uint32_t i = said_.tokens.begin; i < name_start; ++i) {
      const std::string written = text_between(i, said_.head);
      const NounKind meant = misspelt_kind(text_.table, written);
      if (!meant.kind) continue;
      take_name(i, meant, meant.name);
      phrase_.kind.misspelt = written;
      return;
    }
  }
  // "credenza", "gong": nouns that no kind is called by, where something is introduced.
  void inferred_name() {
    if (!is_introduced() || said_.is_pronoun || text_.words.room_parts.count(phrase_.noun)) return;
    for (std::uint32_t i = said_.tokens.begin; i <= said_.head; ++i) {
      const std::string noun = in_singular(i);
      const bool is_word = language::lexicon().has(noun, language::PartOfSpeech::noun);
      if ((i < said_.head && !is_word) || !may_be_thing(text_, noun)) continue;
      const NounKind meant = inferred_kind(text_.table, noun);
      if (!meant.kind) continue;
      take_name(i, meant, noun);
      if (phrase_.kind.is_stand_in()) take_nouns_before();
      return;
    }
  }
  bool is_introduced() const {
    if (said_.determiner != Determiner::absent || said_.count > 0 || said_.is_plural) return true;
    return (said_.list != language::none || is_placed()) && !may_be_stuff(phrase_.noun) &&
           !language::positive(phrase_.noun);
  }
  // "Shredder in the corner."
  bool is_placed() const {
    constexpr double surely = 0.9;
    return language::lexicon().share(phrase_.noun, WordClass::artefact) >= surely &&
           std::any_of(parse_.attachments.begin(), parse_.attachments.end(), [&](const auto& one) {
             return one.from == number_ && one.to != language::none && one.relation != "of";
           });
  }
  void take_name(std::uint32_t first, const NounKind& meant, const std::string& name) {
    start_ = first;
    phrase_.kind = {meant.kind, said_.head + 1 - first, said_.is_plural, name, meant.basis, ""};
    phrase_.end = std::max<std::size_t>(phrase_.end, said_.head + 1);
    phrase_.noun.clear();
  }
  // Of what nobody knows the whole compound is the name: a "gas cylinder".
  void take_nouns_before() {
    while (start_ > said_.tokens.begin && names_what_is_behind(static_cast<std::uint32_t>(start_ - 1))) {
      --start_;
      phrase_.kind.name = word(start_) + " " + phrase_.kind.name;
      ++phrase_.kind.length;
    }
  }
  bool names_what_is_behind(std::uint32_t token) const {
    const auto& english = language::lexicon();
    const std::string& here = word(token);
    return is_modifier(token) && english.has(here, language::PartOfSpeech::noun) &&
           !english.has(here, language::PartOfSpeech::adjective) && !text_.words.materials.count(here) &&
           !text_.words.sizes.count(here) && !english.may_be(here, WordClass::color);
  }
  std::string text_between(std::uint32_t first, std::uint32_t last) const {
    std::string text = word(first);
    for (auto i = first + 1; i <= last; ++i) text += " " + word(i);
    return text;
  }
  std::string in_singular(std::uint32_t first) const {
    const std::string head = parse_.head_of(said_);
    return first == said_.head ? head : text_between(first, said_.head - 1) + " " + head;
  }

  void count() {
    phrase_.definite = said_.determiner == Determiner::definite ||
                       said_.determiner == Determiner::possessive ||
                       said_.determiner == Determiner::each || said_.determiner == Determiner::both;
    phrase_.another = said_.determiner == Determiner::another;
    phrase_.article = phrase_.another || said_.determiner == Determiner::indefinite;
    qualifier();
    for (std::uint32_t i = said_.tokens.begin; i < start_; ++i) count_word(i);
    range();
    if (phrase_.article || said_.count <= 0) return;
    // Numbers of several words.
    const bool part_of_name = is_number(start_) || measured_;
    if (!part_of_name) set_count(said_.count, true);
  }

  // "8 to 12", "two or three", "about a dozen": what stands before the noun is a range.
  void range() {
    for (std::uint32_t first = said_.tokens.begin; first < start_; ++first) {
      const auto amount = language::amount_at(parse_.tokens, first);
      if (!amount || amount->is_share || first + amount->length > start_) continue;
      const auto [least, most] = language::counted_bounds(*amount);
      if (most > max_count || most <= least || least < 1.0) return;
      set_count(std::round(0.5 * (least + most)), true);
      phrase_.least = static_cast<int>(least), phrase_.most = static_cast<int>(most);
      for (auto i = first; i < first + amount->length; ++i) phrase_.count_tokens.push_back(i);
      return;
    }
  }
  // "at least five", "exactly two", "no more than one"
  void qualifier() {
    static const WordSet words = {"least", "exactly", "only",  "more",   "most",
                                  "just",  "than",    "fewer", "precisely"};
    auto first = said_.tokens.begin, end = first;
    while (said_.tokens.begin - first < 3 && first > 0 && words.count(word(first - 1))) --first;
    while (end < start_ && (words.count(word(end)) || word(end) == "at")) ++end;
    for (auto i = first; i < end; ++i) phrase_.count_tokens.push_back(i);
    if (first < end) limit(first);
  }
  // "at", "no" may stand before the words that qualify.
  void limit(std::uint32_t first) {
    using Limit = language::Measure::Limit;
    auto bound = first > 0 ? language::bound_at(parse_.tokens, first - 1) : language::Bound{};
    if (bound.length > 0) phrase_.count_tokens.push_back(first - 1);
    if (bound.length == 0) bound = language::bound_at(parse_.tokens, first);
    phrase_.at_least = bound.limit == Limit::least;
    phrase_.at_most = bound.limit == Limit::most;
  }

  void count_word(std::uint32_t token) {
    const std::string& here = word(token);
    static const WordSet sets = {"set", "pair", "group", "row", "collection", "series"};
    phrase_.set = phrase_.set || (sets.count(here) && token < start_);
    if (text_.words.further.count(here) && !is_modifier(token))
      add_modifier(here, {token, token + 1});
    if (is_measured(token)) {
      measured_ = true;
      const auto number = text_.words.numbers.find(here);
      const int value = number != text_.words.numbers.end()
                            ? number->second
                            : static_cast<int>(std::min(text_.plain[token].value, 100.0));
      const std::string& what = word(token + 1);
      if (what == "seat" || what == "seater" || what == "person") phrase_.seats = value;
      add_modifier(here + " " + what, {token, token + 2});
    } else if (text_.plain[token].kind == Token::Kind::number) {
      phrase_.count_tokens.push_back(token);
      if (said_.measure == language::none)
        set_count(said_.count, true);
    } else if (const auto number = text_.words.numbers.find(here);
               number != text_.words.numbers.end() && !is_modifier(token)) {
      // "a dozen", "twenty-four": what the parse makes of the words counts.
      phrase_.count_tokens.push_back(token);
      const bool exact = !text_.words.vague.count(here);
      const double said = is_number(start_) ? 0.0 : said_.count;
      set_count(exact && said >= 1.0 ? said : number->second, exact);
    }
  }
  void set_count(double number, bool exact) {
    phrase_.count = static_cast<int>(std::clamp<double>(number, 1, max_count));
    phrase_.beyond = number > max_count ? number : 0.0;
    phrase_.counted = exact;
    phrase_.article = true;
  }

  void add_modifier(std::string word, const Run& tokens) {
    phrase_.modifiers.push_back(std::move(word));
    phrase_.modifier_tokens.push_back(tokens);
  }

  bool is_modifier(std::size_t token) const {
    for (auto i = said_.modifiers.begin; i < said_.modifiers.end; ++i)
      if (parse_.modifiers[i].tokens.begin <= token && token < parse_.modifiers[i].tokens.end)
        return true;
    return false;
  }

  void modifiers() {
    joined_looks();
    for (auto i = said_.modifiers.begin; i < said_.modifiers.end; ++i) {
      const auto& modifier = parse_.modifiers[i];
      add_words(modifier.tokens, start_);
      if (modifier.kind == language::Modifier::Kind::noun && modifier.tokens.end <= start_ &&
          !tells_look(modifier))
        for (auto token = modifier.tokens.begin; token < modifier.tokens.end; ++token)
          if (!begins_tone(token)) phrase_.naming.push_back(word(token));
    }
  }
  // "a striped navy and white rug": what stands before "and" is no phrase of its own.
  void joined_looks() {
    const std::uint32_t first = said_.tokens.begin;
    if (said_.determiner != Determiner::absent || first < 2 || !text_.plain[first - 1].is_word("and")) return;
    std::uint32_t begin = first - 1;
    while (begin > 0 && finish_words().describes(word(begin - 1))) --begin;
    const bool is_introduced_before = begin > 0 && (is_number(begin - 1) || is_article(begin - 1));
    if (is_introduced_before) add_words({begin, first - 1}, start_);
  }
  bool is_article(std::size_t token) const {
    return word(token) == "a" || word(token) == "an" || word(token) == "the";
  }
  // "oak", "corner", "kitchen": of what it is, or where.
  bool tells_look(const language::Modifier& modifier) const {
    for (auto token = modifier.tokens.begin; token < modifier.tokens.end; ++token) {
      const std::string& noun = word(token);
      if (text_.words.materials.count(noun) || text_.words.sizes.count(noun) || text_.words.parts.count(noun) ||
          text_.words.room_parts.count(noun) || text_.words.room_words.count(noun) || may_be_stuff(noun) ||
          language::lexicon().is(noun, WordClass::room) || language::lexicon().is(noun, WordClass::shape) ||
          language::lexicon().is(noun, WordClass::person) || text_.plain[token].kind != Token::Kind::word)
        return true;
    }
    return false;
  }
  // "forest green", "navy blue": the word before a plain colour names its tone, unless it is a stuff or a size.
  bool begins_tone(std::uint32_t i) const {
    const FinishWords& finishes = finish_words();
    if (i + 1 >= start_ || text_.plain[i].kind != Token::Kind::word || !finishes.basic_colors.count(word(i + 1))) return false;
    const std::string& first = word(i);
    if (finishes.basic_colors.count(first)) return false;  // "black white": two of them
    if (finishes.colors.count(first)) return true;
    const auto& english = language::lexicon();
    using language::PartOfSpeech;
    const bool is_other = finishes.describes(first) || text_.words.materials.count(first) || text_.words.sizes.count(first) ||
                          text_.words.room_words.count(first) || is_number(i) || language::is_function_word(parse_.tokens[i]);
    return !is_other && english.tagged(first, PartOfSpeech::noun) > english.tagged(first, PartOfSpeech::adjective);
  }
  void add_words(const Run& run, std::size_t before) {
    for (std::uint32_t i = std::max(run.begin, tone_end_); i < std::min<std::size_t>(run.end, before); ++i) {
      if (begins_tone(i)) {
        add_modifier(word(i) + " " + word(i + 1), {i, i + 2});
        tone_end_ = ++i + 1;
        continue;
      }
      if (is_measured(i)) {
        ++i;
        continue;
      }
      if (text_.plain[i].is_word("built") && i + 1 < run.end && text_.plain[i + 1].is_word("in")) {
        add_modifier("built in", {i, i + 2});
        ++i;
      } else if (text_.plain[i].kind == Token::Kind::word && !language::is_function_word(parse_.tokens[i]) && word(i) != "own") {
        add_modifier(word(i), {i, i + 1});
      }
    }
  }

  // "the sofa is red", "made of oak", "in blue velvet"
  void described_elsewhere() {
    for (const auto& verb : parse_.verbs)
      if (verb.subject == number_ && !verb.is_denied)
        for (auto i = verb.complement.begin; i < verb.complement.end; ++i)
          if (!parse_.modifiers[i].is_denied)
            add_words(parse_.modifiers[i].tokens, text_.plain.size());
    for (const auto& attachment : parse_.attachments)
      if (attachment.from == number_ && !attachment.is_denied && tells_material(attachment)) {
        const auto& material = parse_.phrases[static_cast<std::size_t>(attachment.to)];
        add_words({material.tokens.begin, material.head + 1}, text_.plain.size());
      }
  }
  bool tells_material(const Attachment& attachment) const;
  bool may_be_look(const language::NounPhrase& phrase) const;

  // "a 2 m tall bookcase", "a table 1.6 m long", "the desk is 1.6 m wide"
  void measures() {
    add_measure_in({said_.tokens.begin, said_.tokens.end});
    measures_behind();
    for (const auto& verb : parse_.verbs)
      if (verb.subject == number_)
        verb.is_denied ? add_denied_measure(verb.tokens) : add_measure_in({verb.tokens.end, verb.tokens.end + 1});
  }
  // "that is not taller than 1.8 m": only what is denied with its bound tells a size.
  void add_denied_measure(const Run& verb) {
    for (auto i = verb.begin; i <= verb.end && i < text_.plain.size(); ++i) {
      const auto measure = language::bounded_measure_at(parse_.tokens, i);
      if (!measure || measure->limit == language::Measure::Limit::exact || !text_.words.negations.count(word(i))) continue;
      phrase_.measures.push_back(*measure);
      phrase_.measure_tokens.push_back({i, i + static_cast<std::uint32_t>(measure->length)});
      return;
    }
  }
  // "a bookcase 2.4 m tall and 3 m long", "a desk, 180 x 90 cm": up to what is said of something else.
  void measures_behind() {
    std::uint32_t at = said_.tokens.end;
    for (int n = 0; n < 3; ++n) {
      while (at < text_.plain.size() &&
             (text_.plain[at].kind == Token::Kind::comma || text_.plain[at].is_word("and") ||
              text_.plain[at].is_word("about")))
        ++at;
      const auto measure = language::bounded_measure_at(parse_.tokens, at);
      if (!measure || !measure->has_unit) return;
      const auto end = at + static_cast<std::uint32_t>(measure->length);
      if (is_of_other(end - 1)) return;
      add_measure_in({at, at + 1});
      at = end;
    }
  }
  bool is_of_other(std::uint32_t token) const {
    return std::any_of(parse_.phrases.begin(), parse_.phrases.end(), [&](const auto& other) {
      return &other != &said_ && other.tokens.begin <= token && token < other.tokens.end &&
             other.head >= token;
    });
  }
  // "a no taller than 1.5 m wardrobe": the words that bound may stand before the phrase.
  std::uint32_t with_bound(std::uint32_t measure) const {
    constexpr std::uint32_t longest = 4;
    for (std::uint32_t n = longest; n > 0; --n)
      if (n <= measure && language::bound_at(parse_.tokens, measure - n).length == n) return measure - n;
    return measure;
  }
  // "a shelf 1.5 m above the floor", "2 m from the wall": where it is, and no size.
  bool is_distance(std::size_t behind) const {
    return behind < text_.plain.size() && text_.words.distances.count(word(behind)) > 0;
  }
  // The first that begins there.
  void add_measure_in(const Run& run) {
    for (auto first = run.begin; first < std::min<std::size_t>(run.end, parse_.tokens.size()); ++first) {
      const auto i = with_bound(first);
      const auto measure = language::bounded_measure_at(parse_.tokens, i);
      if (!measure) continue;
      if (is_distance(i + measure->length)) return;
      phrase_.measures.push_back(*measure);
      phrase_.measure_tokens.push_back({i, i + static_cast<std::uint32_t>(measure->length)});
      return;
    }
  }

  // "a jar of honey": bare nouns say what is in it, and are no things beside it.
  void contents() {
    const bool is_told = phrase_.end > said_.tokens.end;  // "a loaf of bread"
    if (phrase_.kind.plural || !phrase_.article || is_told) return;
    for (const auto& attachment : parse_.attachments) {
      if (attachment.from != number_ || attachment.relation != "of" || tells_material(attachment))
        continue;
      const auto& inside = parse_.phrases[static_cast<std::size_t>(attachment.to)];
      if (inside.determiner != Determiner::absent || inside.count > 0 || inside.is_pronoun ||
          text_.words.room_parts.count(word(inside.head)))
        continue;
      phrase_.contents = "of";
      phrase_.contents_tokens = inside.tokens;
      for (auto i = inside.tokens.begin; i < inside.tokens.end; ++i)
        phrase_.contents += " " + word(i);
      return;
    }
  }

  // "headphones", "a pair of scissors"
  void pair_is_one() {
    if (!text_.words.pairs.count(word(said_.head))) return;
    phrase_.kind.plural = false;
    if (phrase_.set || !phrase_.counted) phrase_.count = 1;
    if (said_.head >= 2 && word(said_.head - 2) == "pairs") phrase_.count = std::max(1, phrase_.count / 2);
    phrase_.article = true;
  }

  const PromptText& text_;
  const Parse& parse_;
  const std::int32_t number_;
  const language::NounPhrase& said_;
  std::size_t start_ = 0;  ///< of the name
  bool measured_ = false;
  std::uint32_t tone_end_ = 0;  ///< up to where colours of two words were read
  ThingPhrase phrase_;
};

bool is_bare(const language::NounPhrase& phrase) {
  return phrase.determiner == Determiner::absent && phrase.count == 0 && !phrase.is_pronoun;
}

bool ThingPhraseReader::tells_material(const Attachment& attachment) const {
  if (attachment.is_verb || attachment.to == language::none) return false;
  static const WordSet relations = {"of", "in", "from"};
  const auto& to = parse_.phrases[static_cast<std::size_t>(attachment.to)];
  const std::string& noun = word(to.head);
  if (!relations.count(attachment.relation) || !is_bare(to)) return false;
  if (text_.words.materials.count(noun) || language::lexicon().is(noun, WordClass::color) ||
      (language::lexicon().is(noun, WordClass::material) && !to.is_plural))
    return true;
  return attachment.relation == "in" && !to.is_plural && may_be_look(to);
}

// "in pale ash", "in rust bouclé": what a thing is in, and that may be a colour or what things are
// made of.
bool ThingPhraseReader::may_be_look(const language::NounPhrase& phrase) const {
  for (auto i = phrase.tokens.begin; i <= phrase.head; ++i)
    if (may_be_stuff(word(i)) || text_.words.materials.count(word(i))) return true;
  return false;
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
  return ThingPhraseReader(text, phrase).run();
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

}  // namespace roomgen::design
