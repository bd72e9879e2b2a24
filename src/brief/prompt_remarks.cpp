#include "prompt_remarks.h"

#include <algorithm>

#include "language/function_word.h"

namespace roomgen::design {

namespace {

using language::Attachment;
using language::none;
using language::NounPhrase;
using language::Run;

class RemarkReader {
 public:
  explicit RemarkReader(PromptReading& reading) : reading_(reading), used_(reading.heard_tokens()) {}

  void run() {
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i)
      if (is_of_room(static_cast<std::int32_t>(i))) remark_on_room(static_cast<std::int32_t>(i), 0);
    for (const auto& verb : reading_.parse.verbs)
      if (verb.subject != none && !verb.is_denied && is_somebody(reading_.phrase(verb.subject)))
        remark_on_deed(verb);
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
    return !reading_.mention_of(id) && !reading_.is_taken(said) && !said.is_pronoun && !said.is_denied;
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

}  // namespace roomgen::design
