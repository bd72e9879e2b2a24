#include <algorithm>
#include <cmath>

#include "language/function_word.h"
#include "language/lexicon.h"
#include "language/number.h"
#include "prompt_passes.h"
#include "scene/finish_words.h"

namespace roomgen::brief {

namespace {

using language::Attachment;
using language::Determiner;
using language::none;
using language::NounPhrase;
using language::Run;

class PartitionReader {
 public:
  explicit PartitionReader(PromptReading& reading) : reading_(reading) {}

  void run() {
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i) read_phrase(static_cast<std::int32_t>(i));
  }

 private:
  void read_phrase(std::int32_t id) {
    if (const auto first = what_is_added_to(id)) return add(id, *first);
    const auto whole = whole_of(id);
    if (!whole || reading_.talk.mention(*whole).formation) return;
    const auto looks = looks_of(id);
    const auto* place = place_of(id);
    if (looks.empty() && !place) return;
    const int all = reading_.talk.mention(*whole).quantity, few = share_of(id, place, *whole);
    if (few < 1 || few > all) return;
    const auto own = stands_for_things(id) ? std::nullopt : reading_.mention_of(id);
    if (own) reading_.talk.adopt(*own, *whole);
    const auto part = own ? *own : few == all ? *whole : reading_.talk.part(*whole, few);
    reading_.mentions[static_cast<std::size_t>(id)] = part;
    reading_.is_share[static_cast<std::size_t>(id)] = true;
    const NounPhrase& said = reading_.phrase(id);
    reading_.hearing.number({said.tokens.begin, said.head + 1}, part);
    for (const auto& look : looks) {
      reading_.talk.describe(part, reading_.word(look.begin));
      reading_.hearing.look(look, part, reading_.word(look.begin));
    }
  }

  // "five chairs on each side and one at the head": one more, for the five have their place.
  std::optional<std::size_t> what_is_added_to(std::int32_t id) const {
    const NounPhrase& said = reading_.phrase(id);
    const auto begin = said.tokens.begin;
    if (!said.is_pronoun || said.count < 1 || said.determiner != Determiner::absent || !place_of(id) || begin == 0 ||
        !(reading_.is_word(begin - 1, "and") || is_beyond(said)))
      return std::nullopt;
    for (std::int32_t i = id; i-- > 0 && is_same_sentence(id, i);) {
      if (reading_.means_some(i)) return std::nullopt;
      const NounPhrase& before = reading_.phrase(i);
      const auto named = before.is_pronoun ? std::nullopt : reading_.mention_of(i);
      if (!named || before.count < 2) continue;
      return place_of(i) && whole(*named) ? named : std::nullopt;
    }
    return std::nullopt;
  }
  // "two bikes in front, a third one ..."
  bool is_beyond(const NounPhrase& said) const {
    return language::ordinal_at(reading_.parse.tokens, said.tokens.begin).has_value();
  }
  void add(std::int32_t id, std::size_t first) {
    const NounPhrase& said = reading_.phrase(id);
    const auto further = reading_.talk.another(first, static_cast<int>(said.count));
    reading_.mentions[static_cast<std::size_t>(id)] = further;
    reading_.hearing.number({said.tokens.begin, said.head + 1}, further);
  }

  // "three" of five, "the other two", "another", "two of the chairs"; "two bunk beds" of three, where "one" follows.
  std::optional<std::size_t> whole_of(std::int32_t id) const {
    const NounPhrase& said = reading_.phrase(id);
    if (is_rest(said)) return rest_of(id);
    if (!stands_for_things(id)) return named_again(id);
    if (!said.is_pronoun) return several_before(id);
    if (said.count <= 0 || reading_.place_named(said) || said.determiner == Determiner::each || said.determiner == Determiner::all ||
        said.determiner == Determiner::both || is_of_row(id) || is_bounded(said))
      return std::nullopt;
    for (const Attachment& one : reading_.parse.attachments) {
      if (one.from != id || one.relation != "of") continue;
      const auto all = reading_.mention_of(one.to) ? whole_behind(*reading_.mention_of(one.to)) : std::nullopt;
      if (all || (reading_.mention_of(one.to) && !is_fraction(said))) return all;
      if (is_fraction(said) && !reading_.phrase(one.to).is_pronoun) return std::nullopt;  // "half of the room"
    }
    const auto before = reading_.mention_of(id) ? whole_behind(*reading_.mention_of(id)) : std::nullopt;
    return before || !is_fraction(said) ? before : several_before(id);
  }
  std::optional<std::size_t> whole_behind(std::size_t mention) const {
    const std::size_t known = reading_.talk.mention(mention).part_of;
    return whole(known == Demand::none ? mention : known);
  }
  // "half", "a third"
  static bool is_fraction(const NounPhrase& said) { return said.count > 0 && said.count < 1; }
  // "three" of five; "three red", where a colour comes for the noun.
  bool stands_for_things(std::int32_t id) const {
    const NounPhrase& said = reading_.phrase(id);
    const bool is_elliptic = said.count > 0 && said.determiner == Determiner::absent && is_look(said.head) && is_last_word(said.head) &&
                             reading_.thing(id).kind.length == 0;
    return said.is_pronoun || is_elliptic;
  }
  // The several that were named last in the sentence.
  std::optional<std::size_t> several_before(std::int32_t id) const {
    for (std::int32_t i = id; i-- > 0 && is_same_sentence(id, i);) {
      const auto mention = reading_.mention_of(i);
      if (!mention || reading_.phrase(i).is_pronoun || reading_.means_some(i)) continue;
      const auto all = whole_behind(*mention);
      return all && reading_.phrase(i).count > 1 ? all : std::nullopt;
    }
    return std::nullopt;
  }
  // "never more than three at a round one"
  bool is_bounded(const NounPhrase& said) const {
    const auto begin = said.tokens.begin;
    return said.is_denied || (begin > 0 && (reading_.is_word(begin - 1, "than") || reading_.is_word(begin - 1, "most")));
  }
  // "two columns of four"
  bool is_of_row(std::int32_t id) const {
    return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(), [&](const Attachment& one) {
      return one.to == id && one.relation == "of" && one.from != none &&
             reading_.words.groups.count(reading_.word(reading_.phrase(one.from).head));
    });
  }
  // Several of which the number is known.
  std::optional<std::size_t> whole(std::size_t mention) const {
    const Mention& things = reading_.talk.mention(mention);
    return things.counted && things.quantity > 1 && things.most == 0 ? std::optional(mention) : std::nullopt;
  }
  bool is_rest(const NounPhrase& said) const {
    const std::string& noun = reading_.word(said.head);
    return noun == "rest" || noun == "others" || noun == "remaining" ||
           ((noun == "other" || (noun == "half" && reading_.is_word(said.tokens.begin + 1, "other"))) && said.determiner == Determiner::definite);
  }
  // What was parted before in the text keeps what is left of it.
  std::optional<std::size_t> rest_of(std::int32_t id) const {
    for (std::int32_t i = id; i-- > 0;)
      if (reading_.means_some(i)) {
        const std::size_t whole = reading_.talk.mention(*reading_.mention_of(i)).part_of;
        return whole == Demand::none ? std::nullopt : std::optional(whole);  // all of them leave no rest
      }
    return std::nullopt;
  }
  // "three metal bunk beds. Two bunk beds are against the left wall and one ...": the numbers make up the whole.
  std::optional<std::size_t> named_again(std::int32_t id) const {
    const NounPhrase& said = reading_.phrase(id);
    const auto own = reading_.mention_of(id);
    if (!own || said.count < 1 || said.determiner != Determiner::absent || !reading_.thing(id).modifiers.empty())
      return std::nullopt;
    for (std::size_t other = *own; other-- > 0;) {
      const Mention& before = reading_.talk.mention(other);
      if (before.noun != reading_.talk.mention(*own).noun || !whole(other)) continue;
      return adds_up(id, before.quantity) ? std::optional(other) : std::nullopt;
    }
    return std::nullopt;
  }
  bool adds_up(std::int32_t id, int all) const {
    int sum = static_cast<int>(reading_.phrase(id).count);
    for (auto i = id + 1; i < std::ssize(reading_.parse.phrases) && is_same_sentence(id, i); ++i)
      if (const NounPhrase& next = reading_.phrase(i); next.is_pronoun && next.count >= 1)
        sum += static_cast<int>(next.count);
    return sum == all && sum > reading_.phrase(id).count;
  }
  bool is_same_sentence(std::int32_t a, std::int32_t b) const {
    return reading_.sentence_of(reading_.phrase(a).head) == reading_.sentence_of(reading_.phrase(b).head);
  }

  // The first place of its own.
  const Attachment* place_of(std::int32_t id) const {
    for (const Attachment& one : reading_.parse.attachments) {
      const auto& said = reading_.placement(one);
      if (one.from == id && said && !said->placement->inverse) return &one;
    }
    return nullptr;
  }
  // "four on each long side" are eight; "one in each corner" are all, each in its own.
  int share_of(std::int32_t id, const Attachment* place, std::size_t whole) const {
    const NounPhrase& said = reading_.phrase(id);
    const int all = reading_.talk.mention(whole).quantity;
    if (is_rest(said) && said.count < 1) return all;
    const int count = static_cast<int>(is_fraction(said) ? std::round(said.count * number_with_parts(whole)) : said.count);
    const bool is_each = place && place->to != none &&
                         (reading_.phrase(place->to).determiner == Determiner::each || reading_.placement(*place)->placement->flank);
    if (is_each && (count == 1 || is_fraction(said))) return all;
    return is_each ? 2 * count : count;
  }
  // A second half is a half of all that there were before the first was parted.
  int number_with_parts(std::size_t whole) const {
    int all = 0;
    for (const std::size_t part : reading_.talk.with_parts(whole)) all += reading_.talk.mention(part).quantity;
    return all;
  }

  // "four are square", "one red and one black"
  std::vector<Run> looks_of(std::int32_t id) const {
    std::vector<Run> looks;
    for (const auto& verb : reading_.parse.verbs)
      if (verb.subject == id && !verb.is_denied)
        for (auto i = verb.complement.begin; i < verb.complement.end; ++i)
          if (!reading_.parse.modifiers[i].is_denied) looks.push_back(reading_.parse.modifiers[i].tokens);
    for (const auto& verb : reading_.parse.verbs)
      if (verb.subject == id && verb.base == "be" && !verb.is_denied && verb.object != none) add_looks(looks, verb.object);
    if (stands_for_things(id) && is_look(reading_.phrase(id).head) && is_last_word(reading_.phrase(id).head))
      add_looks(looks, id);
    for (auto i = behind(id); is_look(i); ++i) looks.push_back({i, i + 1});
    return looks;
  }
  // "one of which is metal", "three round"
  void add_looks(std::vector<Run>& looks, std::int32_t id) const {
    const NounPhrase& said = reading_.phrase(id);
    if (id != none && (said.determiner == Determiner::absent || said.is_pronoun))
      for (auto i = said.tokens.begin; i <= said.head; ++i)
        if (is_look(i)) looks.push_back({i, i + 1});
  }
  // Not so of "a red emergency button", whose noun is not known.
  bool is_last_word(std::uint32_t token) const {
    const auto& tokens = reading_.parse.tokens;
    return token + 1 >= tokens.size() || tokens[token + 1].kind != language::Token::Kind::word ||
           language::is_function_word(tokens[token + 1]);
  }
  // The token behind "two", "two of them".
  std::uint32_t behind(std::int32_t id) const {
    const auto next = reading_.phrase(id).head + 1;
    static const WordSet all = {"them", "these", "those", "which"};
    const bool names_all = reading_.is_word(next, "of") && next + 1 < reading_.text.plain.size() && all.count(reading_.word(next + 1)) > 0;
    return names_all ? next + 2 : next;
  }
  bool is_look(std::uint32_t token) const {
    if (token >= reading_.text.plain.size() || reading_.text.plain[token].kind != Token::Kind::word) return false;
    const std::string& word = reading_.word(token);
    const auto& english = language::lexicon();
    return finish_words().describes(word) || reading_.words.materials.count(word) || english.is(word, language::WordClass::color) ||
           english.may_be(word, language::WordClass::shape);
  }

  PromptReading& reading_;
};

}  // namespace

void read_partitions(PromptReading& reading) { PartitionReader(reading).run(); }

}  // namespace roomgen::brief
