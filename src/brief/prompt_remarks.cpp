#include <algorithm>

#include "kinds/noun_kind.h"
#include "language/function_word.h"
#include "language/inflection.h"
#include "language/lexicon.h"
#include "prompt_passes.h"
#include "scene/finish_words.h"

namespace roomgen::brief {

namespace {

using language::Attachment;
using language::none;
using language::NounPhrase;
using language::Run;

// Words of clauses that no verdict covers: where one can pass, what one can reach or see, gaps and aisles, and the
// figures in which things stand.
bool tells_what_nothing_shows(const std::string& word) {
  static const WordSet words = {"clear",   "free",       "empty",    "unobstructed", "unblocked", "passable", "reach",   "reachable",
                                "reaches", "visible",    "invisible", "accessible",  "escape",    "see",      "apart",   "away",
                                "aisle",   "aisles",     "passage",  "gap",          "gaps",      "path",     "walkway", "clearance",
                                "circle",  "semicircle", "horseshoe", "arc",         "arcs",      "staggered",   "because"};
  return words.count(word) > 0;
}

class RemarkReader {
 public:
  explicit RemarkReader(PromptReading& reading) : reading_(reading), used_(reading.tokens_with_sense()) {}

  void run() {
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i)
      if (is_of_room(static_cast<std::int32_t>(i))) remark_on_room(static_cast<std::int32_t>(i), 0);
    for (const auto& verb : reading_.parse.verbs)
      if (verb.subject != none && !verb.is_denied && is_somebody(reading_.phrase(verb.subject)))
        remark_on_deed(verb);
    pass_over_courtesies();
    remark_on_what_nothing_shows();
    remark_on_moods();
  }

 private:
  static constexpr int most_steps = 3;

  bool is_of_room(std::int32_t id) const {
    return reading_.is_room(reading_.phrase(id)) && !reading_.mention_of(id);
  }
  // "a rented flat", and what is said of it: "by the sea", "for a clinic".
  void remark_on_room(std::int32_t id, int steps) {
    const NounPhrase& said = reading_.phrase(id);
    remark({said.tokens.begin, said.head + 1}, Heard::As::room);
    if (steps >= most_steps) return;
    for (const Attachment& attachment : reading_.parse.attachments)
      if (attachment.from == id && attachment.to > id && !attachment.is_denied && is_remark(attachment.to))
        remark_on_room(attachment.to, steps + 1);
  }
  bool is_remark(std::int32_t id) const {
    const NounPhrase& said = reading_.phrase(id);
    return !reading_.mention_of(id) && !reading_.is_taken(said) && !said.is_pronoun && !said.is_denied && !is_of_place(reading_.word(said.head));
  }

  bool is_somebody(const NounPhrase& said) const {
    static const WordSet pronouns = {"i", "we", "you", "he", "she", "who", "somebody", "someone", "everybody", "everyone"};
    if (said.is_pronoun) return pronouns.count(reading_.word(said.head)) > 0;
    return reading_.is_somebody(said);
  }
  // "argue about a boundary": with what it is about, where that is no thing.
  void remark_on_deed(const language::VerbPhrase& verb) {
    remark(verb.tokens, Heard::As::activity);
    const auto about = [&](std::int32_t id) {
      if (id == none || !is_remark(id)) return;
      const NounPhrase& said = reading_.phrase(id);
      remark({said.tokens.begin, said.head + 1}, Heard::As::activity);
    };
    about(verb.object);
    const auto index = static_cast<std::int32_t>(&verb - reading_.parse.verbs.data());
    for (const Attachment& attachment : reading_.parse.attachments)
      if (attachment.verb == index && !attachment.is_denied) about(attachment.to);
  }

  void pass_over_courtesies() {
    for (std::uint32_t i = 0; i < used_.size(); ++i) {
      if (used_[i] || !reading_.words.courtesies.count(reading_.word(i))) continue;
      hear(reading_.brief, {i, i + 1}, Heard::As::room);
      used_[i] = true;
    }
  }

  // "Keep 90 cm clear from the door to the balcony": from the verb or the mark before to the mark behind.
  void remark_on_what_nothing_shows() {
    for (std::uint32_t i = 0; i < used_.size(); ++i) {
      if (used_[i] || !tells_what_nothing_shows(reading_.word(i))) continue;
      Run clause{i, i + 1};
      while (clause.begin > 0 && !is_mark(clause.begin - 1)) --clause.begin;
      while (clause.end < used_.size() && !is_mark(clause.end)) ++clause.end;
      for_each_left(clause, [&](const Run& piece) {
        if (!names_something(piece)) remark(piece, Heard::As::activity);
      });
    }
  }

  // "two robot arms on it about 1 m apart": no thing is passed over.
  bool names_something(const Run& run) const {
    return std::any_of(reading_.parse.phrases.begin(), reading_.parse.phrases.end(), [&](const NounPhrase& phrase) {
      const std::string noun = language::singular(reading_.word(phrase.head));
      return phrase.head >= run.begin && phrase.head < run.end && (phrase.count > 0 || phrase.determiner == language::Determiner::indefinite) &&
             !phrase.is_pronoun && is_physical(noun) && !is_of_place(noun) && !tells_what_nothing_shows(reading_.word(phrase.head));
    });
  }

  // "Unfussy, windblown", "time forgets to pass", "a silence you'd pay for": where no word of what is left between two
  // marks names anything that one could touch, count or measure, nothing in a room can show it.
  void remark_on_moods() {
    for (std::uint32_t begin = 0; begin < used_.size();) {
      std::uint32_t end = begin;
      while (end < used_.size() && !is_mark(end)) ++end;
      for_each_left({begin, end}, [&](const Run& piece) {
        if (is_untouchable(piece)) remark(piece, tells_deed(piece) ? Heard::As::activity : Heard::As::room);
      });
      begin = end + 1;
    }
  }

  bool is_mark(std::uint32_t token) const {
    const auto kind = reading_.text.plain[token].kind;
    return kind != Token::Kind::word && kind != Token::Kind::number && kind != Token::Kind::room;
  }
  // The stretches of a run that nobody heard.
  template <typename Each>
  void for_each_left(const Run& run, const Each& each) {
    for (auto i = run.begin; i < run.end;) {
      auto end = i;
      while (end < run.end && !used_[end]) ++end;
      if (end > i) each(Run{i, end});
      i = std::max(end, i + 1);
    }
  }
  bool is_untouchable(const Run& run) const {
    bool says_something = false;
    for (auto i = run.begin; i < run.end; ++i) {
      if (language::is_function_word(reading_.parse.tokens[i]) || reading_.words.negations.count(reading_.word(i)))
        continue;
      if (!is_untouchable(i)) return false;
      says_something = true;
    }
    return says_something;
  }
  bool is_untouchable(std::uint32_t token) const {
    const std::string& word = reading_.word(token);
    if (reading_.text.plain[token].kind != Token::Kind::word || reading_.taken[token] == Taken::yes || is_of_place(word) ||
        reading_.text.table.named(word) || finish_words().describes(word))
      return false;
    if (reading_.words.no_things.count(word)) return true;
    const auto verb = language::verb(word);
    const std::string noun = language::singular(word);
    // "unfussy"
    if (word.starts_with("un") && language::lexicon().has(word.substr(2), language::PartOfSpeech::adjective)) return true;
    const double said = said_as(noun, language::PartOfSpeech::noun);
    const double other = said_as(word, language::PartOfSpeech::adjective) + said_as(word, language::PartOfSpeech::adverb) +
                         (verb ? said_as(verb->base, language::PartOfSpeech::verb) : 0.0);
    if (other > said && !is_introduced(token)) return true;
    return said > 0.0 && !is_physical(noun);
  }
  // "a stand", "two locks": whatever else the word may be, here it is a noun.
  bool is_introduced(std::uint32_t token) const {
    return std::any_of(reading_.parse.phrases.begin(), reading_.parse.phrases.end(), [&](const NounPhrase& phrase) {
      return phrase.head == token && !phrase.is_pronoun &&
             (phrase.determiner != language::Determiner::absent || phrase.count > 0);
    });
  }
  // Places, numbers, sizes and what stands for several are never moods.
  bool is_of_place(const std::string& said) const {
    return names_place(said) || names_place(language::singular(said));
  }
  bool names_place(const std::string& word) const {
    const Vocabulary& words = reading_.words;
    return words.room_parts.count(word) || words.walls.count(word) || words.shares.count(word) || words.portions.count(word) ||
           words.parts.count(word) || words.groups.count(word) || words.sizes.count(word) || words.numbers.count(word) ||
           words.placements.count(word) || words.materials.count(word) || words.measured.count(word);
  }
  // How often a word is met so, at least once for what the lexicon has at all.
  static double said_as(const std::string& word, language::PartOfSpeech part) {
    const auto& english = language::lexicon();
    return english.has(word, part) ? 0.5 + english.tagged(word, part) : 0.0;
  }
  bool tells_deed(const Run& run) const {
    return std::any_of(reading_.parse.verbs.begin(), reading_.parse.verbs.end(), [&](const auto& verb) {
      return verb.tokens.begin >= run.begin && verb.tokens.begin < run.end;
    });
  }

  // The words of a run that nobody heard, without function words at its ends.
  void remark(Run run, Heard::As as) {
    const auto is_left = [&](std::uint32_t token) {
      return !used_[token] && !language::is_function_word(reading_.parse.tokens[token]);
    };
    while (!run.empty() && !is_left(run.begin)) ++run.begin;
    while (!run.empty() && !is_left(run.end - 1)) --run.end;
    for (auto i = run.begin; i < run.end; ++i)
      if (used_[i]) return;
    if (run.empty()) return;
    std::fill(used_.begin() + run.begin, used_.begin() + run.end, true);
    hear(reading_.brief, run, as, said_remark);
  }

  PromptReading& reading_;
  std::vector<bool> used_;  ///< by token
};

}  // namespace

void read_remarks(PromptReading& reading) { RemarkReader(reading).run(); }

}  // namespace roomgen::brief
