#include "language/function_word.h"
#include "language/inflection.h"
#include "language/lexicon.h"
#include "language/number.h"
#include "mention_shape.h"
#include "prompt_passes.h"
#include "scene/finish_words.h"
#include "style_phrase.h"

namespace roomgen::brief {

namespace {

using language::Run;

/// What a run of tokens between two marks says of a thing.
struct Addition {
  struct Look {
    std::string word;
    Run tokens;
  };
  std::vector<Look> looks;
  std::vector<std::int32_t> parts;  ///< noun phrases: "white doors"
  std::vector<language::Measure> measures;
  std::vector<Run> measure_tokens;
  int count = 0;
  Run count_tokens;
};

class AdditionReader {
 public:
  explicit AdditionReader(PromptReading& reading)
      : reading_(reading), tokens_(reading.parse.tokens), heard_(reading.heard_tokens()) {}

  void run() {
    std::uint32_t begin = 0;
    for (std::uint32_t i = 0; i <= tokens_.size(); ++i) {
      if (i < tokens_.size() && !is_mark(i)) continue;
      read_segment({begin, i});
      begin = i + 1;
    }
  }

 private:
  using Kind = language::Token::Kind;

  bool is_mark(std::uint32_t token) const {
    const Kind kind = tokens_[token].kind;
    return kind == Kind::comma || kind == Kind::stop || kind == Kind::open || kind == Kind::close;
  }
  // Behind the mark of another sentence nothing is added; a colon announces it.
  bool is_joined(std::uint32_t token) const {
    const auto& mark = tokens_[token];
    return mark.kind != Kind::stop || mark.text == ":";
  }

  void read_segment(const Run& segment) {
    const auto target = target_;
    target_ = thing_in(segment);
    if (target_ || segment.empty() || segment.begin == 0 || reading_.words.negations.count(reading_.word(segment.begin))) return;
    if (!target || !is_joined(segment.begin - 1)) return;
    // "a desk and two armchairs, all in green": what the whole list is in, the room is.
    if (reading_.is_word(segment.begin, "all") &&
        reading_.talk.mention(*target).list != language::none)
      return;
    if (const auto addition = addition_in(segment)) {
      const std::size_t meant = addition->count > 1 ? several_at(*target) : *target;
      add(meant, *addition);
      stand_for(meant, segment);
      target_ = meant;  // "2 m tall, anthracite"
    }
  }
  // The thing that a segment names last: what comes behind is added to it.
  std::optional<std::size_t> thing_in(const Run& segment) const {
    std::optional<std::size_t> last;
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i) {
      const auto& phrase = reading_.parse.phrases[i];
      if (phrase.head >= segment.begin && phrase.head < segment.end && !phrase.is_pronoun &&
          reading_.mentions[i])
        last = reading_.mentions[i];
    }
    return last;
  }

  // "hooks above the bench, six of them": no bench, of which there is one.
  std::size_t several_at(std::size_t target) const {
    if (reading_.talk.mention(target).quantity != 1) return target;
    const auto several = reading_.talk.last_of_several({target}, true);
    return several && *several < target ? *several : target;
  }

  // Every word of it is needed.
  std::optional<Addition> addition_in(const Run& segment) const {
    Addition addition;
    std::uint32_t i = segment.begin;
    while (i < segment.end) {
      const std::uint32_t next = read_piece(i, segment, addition);
      if (next == i || next > segment.end) return std::nullopt;
      i = next;
    }
    return addition;
  }
  // The token behind what is read there; the same one if nothing is.
  std::uint32_t read_piece(std::uint32_t at, const Run& segment, Addition& addition) const {
    if (reading_.taken[at] != Taken::no) return at;
    if (const auto measure = language::bounded_measure_at(tokens_, at)) {
      const auto end = at + static_cast<std::uint32_t>(measure->length);
      if (heard_[at]) return end;
      addition.measures.push_back(*measure);
      addition.measure_tokens.push_back({at, end});
      return end;
    }
    if (const auto end = read_count(at, segment, addition); end > at) return end;
    if (const auto part = part_at(at, segment)) {
      addition.parts.push_back(*part);
      return reading_.phrase(*part).head + 1;
    }
    if (is_look(at)) {
      addition.looks.push_back({reading_.word(at), {at, at + 1}});
      return at + 1;
    }
    static const WordSet joints = {"and", "each", "all", "about", "with", "in"};
    return joints.count(reading_.word(at)) && at + 1 < segment.end ? at + 1 : at;
  }
  // "ten", "exactly two", "four in number": nothing else is in the segment.
  std::uint32_t read_count(std::uint32_t at, const Run& segment, Addition& addition) const {
    if (at != segment.begin) return at;
    static const WordSet qualifiers = {"exactly", "just", "precisely"};
    const std::uint32_t first = qualifiers.count(reading_.word(at)) ? at + 1 : at;
    const auto number = language::number_at(tokens_, first);
    if (!number || number->value < 1.0 || number->value > max_count) return at;
    auto end = first + static_cast<std::uint32_t>(number->length);
    if (reading_.is_word(end, "in") && reading_.is_word(end + 1, "number")) end += 2;
    if (reading_.is_word(end, "of") && reading_.is_word(end + 1, "them")) end += 2;
    if (end != segment.end) return at;
    addition.count = static_cast<int>(number->value);
    addition.count_tokens = {at, end};
    return end;
  }
  // "white footrest": of what was named.
  std::optional<std::int32_t> part_at(std::uint32_t at, const Run& segment) const {
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i) {
      const auto& phrase = reading_.parse.phrases[i];
      if (phrase.tokens.begin == at && phrase.head < segment.end && !phrase.is_pronoun &&
          reading_.words.parts.count(reading_.word(phrase.head)))
        return static_cast<std::int32_t>(i);
    }
    return std::nullopt;
  }
  // A word that says what something is like: a colour, a stuff, an adjective, a participle.
  bool is_look(std::uint32_t at) const {
    using language::PartOfSpeech;
    const std::string& word = reading_.word(at);
    const auto& english = language::lexicon();
    if (tokens_[at].kind != Kind::word || language::is_function_word(tokens_[at]) || reading_.words.numbers.count(word)) return false;
    if (reading_.words.materials.count(word) || reading_.words.sizes.count(word) ||
        may_be_stuff(word) || finish_words().describes(word))
      return true;
    if (const auto verb = language::verb(word);
        verb && (verb->form == language::VerbForm::past || verb->form == language::VerbForm::past_participle))
      return !reading_.words.verbs.count(word);
    return english.tagged(word, PartOfSpeech::adjective) >= english.tagged(word, PartOfSpeech::noun) &&
           english.has(word, PartOfSpeech::adjective) && !names_style(at);
  }
  // "rustic" behind a thing may be said of the room.
  bool names_style(std::uint32_t at) const {
    return style_at(reading_.text.plain, at, reading_.kinds).has_value();
  }

  // "anthracite, along the wall": what is said of the addition is said of the thing.
  void stand_for(std::size_t mention, const Run& segment) {
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i) {
      const auto head = reading_.parse.phrases[i].head;
      if (head >= segment.begin && head < segment.end && !reading_.mentions[i])
        reading_.mentions[i] = mention;
    }
  }
  void add(std::size_t mention, const Addition& addition) {
    for (std::size_t i = 0; i < addition.measures.size(); ++i) {
      set_length(reading_.brief.mentions[mention], addition.measures[i]);
      reading_.hearing.length(addition.measure_tokens[i], mention);
    }
    if (addition.count > 0) {
      reading_.talk.set_count(mention, addition.count);
      reading_.hearing.number(addition.count_tokens, mention);
    }
    for (const auto part : addition.parts) reading_.hearing.part(part, mention);
    for (const auto& look : addition.looks) {
      reading_.talk.describe(mention, look.word);
      reading_.hearing.look(look.tokens, mention, look.word);
    }
  }

  static constexpr double max_count = 200.0;

  PromptReading& reading_;
  const std::vector<language::Token>& tokens_;
  const std::vector<bool> heard_;  ///< by token: said of the thing already
  std::optional<std::size_t> target_;  ///< the mention to which the next segment would add
};

}  // namespace

void read_additions(PromptReading& reading) { AdditionReader(reading).run(); }

}  // namespace roomgen::brief
