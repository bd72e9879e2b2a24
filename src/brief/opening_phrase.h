#pragma once

#include <optional>
#include <span>
#include <vector>

#include "brief.h"
#include "kind_mention.h"
#include "opening_wish.h"
#include "prompt_words.h"
#include "scene/opening_kind.h"
#include "tokens.h"

namespace roomgen::brief {

/// "two tall windows on the left wall", "the door is opposite the window"
struct OpeningPhrase {
  OpeningWish wish;
  bool definite = false;  ///< "the door": one that is spoken of already, or goes without saying
  bool plural = false;
  bool special = false;   ///< the kind is named by more than "door" or "window"
  bool enlarged = false;  ///< "large", "wide"
  std::size_t end = 0;    ///< the token behind it
  std::vector<std::size_t> unread;  ///< adjectives that say nothing that one can build: "broken"
};

/// Reads a phrase about doors, windows or passages that begins at `at`, with the place that follows
/// it or was said just before it in the sentence that begins at `sentence`. Nothing where the words
/// belong to a thing: "a door mat", "a french door refrigerator".
std::optional<OpeningPhrase> read_opening(std::span<const Token> tokens, std::size_t at,
                                          std::size_t sentence, const Vocabulary& words,
                                          const KindTable& table, const OpeningKinds& kinds);

/// Makes the phrase part of the brief: a wish of its own, more about one that is there, or a number
/// of windows.
void ask_for(const OpeningPhrase& phrase, Brief& brief);

/// The length in tokens of the name of a kind of opening at `at`; 0 if there is none.
std::size_t opening_name_at(std::span<const Token> tokens, std::size_t at,
                            const OpeningKinds& kinds);

}  // namespace roomgen::brief
