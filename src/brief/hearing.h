#pragma once

#include <cstdint>

#include "brief.h"
#include "thing_phrase.h"

namespace roomgen::brief {

/// Notes in a brief what the words of its prompt were taken for.
class Hearing {
 public:
  Hearing(const PromptText& text, Brief& brief) : text_(text), brief_(brief) {}

  /// What a noun phrase says of the thing that it names: its name, number, looks and lengths. What is said of the looks
  /// of a thing that was spoken of before counts where the thing is known to be so.
  void thing(const ThingPhrase& thing, std::size_t mention);
  /// What a thing has: "with drawers".
  void part(std::int32_t phrase, std::size_t owner);
  void absence(std::int32_t phrase, const std::string& category);
  /// How many there are of a thing, in words of their own: "three rows" of seats, "chairs: ten".
  void number(std::int32_t phrase, std::size_t mention);
  void number(const language::Run& tokens, std::size_t mention);
  /// Words behind a thing that say how long it is, what it is like.
  void length(const language::Run& tokens, std::size_t mention);
  void look(const language::Run& tokens, std::size_t mention, const std::string& word);
  /// Words that stand for a thing: "its top", "one".
  void stand_in(std::int32_t phrase, std::size_t mention);
  /// The words of a place, with its verb; `place` is a phrase that is no thing, or none.
  std::size_t relation(const language::Attachment& attachment, std::int32_t place);
  /// Verbs that say no more than that a thing is there ("the desk holds a lamp", "add a rug"): they
  /// count as the words of the thing.
  void plain_verbs(const std::vector<std::optional<std::size_t>>& mention_of);

 private:
  std::size_t note(std::size_t mention, const language::Run& tokens, Heard::As as,
                   std::string word = "");
  const language::NounPhrase& phrase(std::int32_t i) const {
    return text_.parse.phrases[static_cast<std::size_t>(i)];
  }

  const PromptText& text_;
  Brief& brief_;
};

}  // namespace roomgen::brief
