#pragma once

#include <functional>
#include <optional>

#include "clause.h"

namespace roomgen {

/// A verb of data/edits.json as it is said.
struct SaidVerb {
  std::string meaning, words;
  std::size_t length = 0;
  bool inflected = false;  ///< "turning", "lacquered"
};
std::optional<SaidVerb> verb_at(const EditText& text, std::size_t at);

/// Where words that name what a clause is about may end: with words of place behind them, or without.
std::vector<std::size_t> ends_of_subject(const EditText& text, std::size_t at);

/// A clause that begins with what it is about: "the armchair should change places with the desk", "both can be
/// removed". It is read as the order that it means, by `read`; nothing if it has no such verb.
using ReadOrder = std::function<ReadClause(const EditText&, const SaidVerb&, std::size_t)>;
std::optional<ReadClause> clause_with_subject(const EditText& text, std::size_t at, const ReadOrder& read);

/// Within so many tokens a clause says who does something: "our noisy new neighbours".
inline constexpr std::size_t longest_somebody = 4;

/// How many tokens say that somebody wants something: "my son would like"; 0 if none do.
std::size_t wish_of_somebody(const EditText& text, std::size_t at);

}  // namespace roomgen
