#pragma once

#include <optional>

#include "discourse.h"
#include "occupants.h"
#include "thing_phrase.h"

namespace roomgen::brief {

/// Words of a prompt that name people or what they do.
struct OccupantPhrase {
  const Occupant* occupant = nullptr;
  language::Run tokens;
  int persons = 0;  ///< 0: not said how many
};

/// The longest name of people or an activity that begins at a token, whether or not the words are
/// part of the name of a thing ("reading lamp").
std::optional<OccupantPhrase> occupant_at(const PromptText& text, const Occupants& occupants,
                                          std::uint32_t token);

/// Adds the things that people need and what they do needs, unless the prompt names such things
/// itself, and notes the words as the reason. The mention of the first thing.
std::optional<std::size_t> bring_things(const OccupantPhrase& phrase, const Occupants& occupants,
                                        const Lexicon& lexicon, Brief& brief);

}  // namespace roomgen::brief
