#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace roomgen::language {

/// Forms of English words, in lower case. Irregular ones and the choice between spellings come from
/// the lexicon; words that it does not know are inflected by their ending alone.

/// A noun in the singular: shelves gives shelf, glasses glass, vases vase. A singular stays as it
/// is (glass, canvas, bus), as do words that are no nouns at all. Of several words the last
/// changes.
std::string singular(std::string_view noun);
/// All that a noun may be in the singular, the likeliest first, the word itself last if it may be
/// one: axes gives ax, axe, axis.
std::vector<std::string> singulars(std::string_view noun);
/// The usual plural: shelf gives shelves, box boxes, sheep sheep.
std::string plural(std::string_view noun);
/// Whether the noun has another form in the singular.
bool is_plural(std::string_view noun);

/// The form of a verb.
enum class VerbForm { base, third_person, past, past_participle, gerund };

struct Verb {
  std::string base;
  VerbForm form = VerbForm::base;  ///< past for what may be a participle too
};

/// What a word is as a verb: "stands" stand, third person; nothing if it is none.
std::optional<Verb> verb(std::string_view word);

/// An adjective in the positive: taller gives tall; nothing if the word is no comparative or
/// superlative of an adjective that the lexicon knows.
std::optional<std::string> positive(std::string_view adjective);

}  // namespace roomgen::language
