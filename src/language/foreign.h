#pragma once

#include <optional>
#include <string>
#include <vector>

#include "language/token.h"

namespace roomgen::language {

/// Another language than English, as its small words show.
struct ForeignLanguage {
  std::string name;     ///< "German"
  std::string refusal;  ///< in that language: that only English is read, and what to do
};

/// The language of a text that has at least two small words of it, and more than of English; of
/// those in data/language/foreign.json only.
std::optional<ForeignLanguage> foreign_language(const std::vector<Token>& tokens);

}  // namespace roomgen::language
