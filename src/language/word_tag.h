#pragma once

#include <cstdint>
#include <string_view>

namespace roomgen::language {

/// What a word does in its sentence. The corpus (data/language/tagged) writes them as letters.
enum class WordTag : std::uint8_t {
  determiner,
  quantity,
  unit,       ///< "cm" where no number told it
  adjective,  ///< participles before their noun too
  noun,
  owner,  ///< "cat's"
  verb,   ///< finite, of a command, or an infinitive
  auxiliary,
  gerund,      ///< "facing the window"
  participle,  ///< "made of oak", "is placed"
  preposition,
  adverb,
  conjunction,
  relative,    ///< and what begins a clause below another: "while"
  infinitive,  ///< "to" of one
  pronoun,
  there,  ///< of "there is"
  other
};

inline constexpr std::string_view word_tag_letters = "DQUJNOVXGEPRCMTIHZ";
inline constexpr std::size_t word_tag_count = word_tag_letters.size();

}  // namespace roomgen::language
