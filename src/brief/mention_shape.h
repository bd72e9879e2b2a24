#pragma once

#include "brief.h"
#include "kind_mention.h"
#include "prompt_words.h"
#include "thing_phrase.h"

namespace roomgen::brief {

/// Size, mount and number of seats of a mention, from its category and the words around it.
void shape(Mention& mention, const ThingPhrase& phrase, const Vocabulary& words,
           const KindTable& table);

/// So many things of a kind that the prompt does not name, but the people of whom it speaks need.
Mention mention_for_people(const std::string& kind, int number, const Vocabulary& words,
                           const KindTable& table);

/// A length or sides that are told of a thing; what is at most or at least so long keeps its own within that; the one
/// length of a screen is its diagonal.
void set_length(Mention& mention, const language::Measure& measure);

/// What is smaller, metres, may stand on other things.
inline constexpr double small_side = 0.7;

/// Tables, cabinets, shelves and counters: where small things are kept.
bool keeps_things(const std::string& category, const KindTable& table);

/// Whether a thing stands with its back to a wall.
bool needs_wall(const Mention& mention, const KindTable& table);

/// Makes a mention one that hangs on a wall or under the ceiling, if such a thing can: a television
/// becomes a wall tv, a wardrobe "on the wall" stays what it is. Small things can also stand on the
/// floor.
void hang(Mention& mention, Mount where, const KindTable& table);

/// How high above the floor a mention shall hang, as it is said, and its middle in metres; none if nothing is said.
void set_hanging_height(Mention& mention, const language::Measure& measure);
std::optional<double> hanging_height(const Mention& mention);

/// Makes a mention what stands on tables: a table lamp, a small plant; a fern stays a fern, as small
/// as small plants are. False if there is no such kind.
bool become_small(Mention& mention, const KindTable& table);

}  // namespace roomgen::brief
