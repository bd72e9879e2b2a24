#pragma once

#include <map>
#include <set>
#include <span>
#include <string>

#include "measure.h"
#include "parse.h"
#include "token.h"

namespace roomgen::language {

using Words = std::set<std::string, std::less<>>;

/// The words of data/language/words.json; docs/language.md explains the lists.
struct SmallWords {
  std::map<std::string, double, std::less<>> numbers, scales, fractions, ordinals, lengths, areas,
      counted_quantities;
  std::map<std::string, Measure::Side, std::less<>> sides, comparatives;
  std::map<std::string, Determiner, std::less<>> determiners;
  std::map<std::string, std::string, std::less<>> contractions;
  Words vague_numbers, pronouns, standing_alone, negative_pronouns, relatives, conjunctions,
      additions, subordinators, negations, be, auxiliaries, verbs_of_denial, verbs_of_having,
      compounds, prepositions, prepositions_behind_things, sides_without_preposition,
      denying_prepositions, adverbs, quantities, plurals, exceptions, upper_limits, lower_limits,
      excluded_upper_limits, excluded_lower_limits, upper_limits_behind, lower_limits_behind, exact,
      approximations, approximations_behind;
};

const SmallWords& small_words();

/// How many tokens from `at` on are the longest phrase of the set; 0 if none is.
std::size_t longest_run(const Words& phrases, std::span<const Token> tokens, std::size_t at,
                        std::size_t most = 4);

}  // namespace roomgen::language
