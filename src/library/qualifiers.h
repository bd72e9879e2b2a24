#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "vocabulary.h"

namespace roomgen {

/// A description by what its words are about: "a low oak desk with three drawers and round brass
/// knobs beside the bed" is a desk, low and of oak, and has three drawers and round brass knobs.
struct Qualifiers {
  std::string head;                ///< up to and with the thing's own noun: "low oak desk"
  std::vector<std::string> own;    ///< words that say how the thing is; its name is left out
  std::vector<std::string> parts;  ///< words about what it has
};
Qualifiers qualify(std::string_view description,
                   const Vocabulary& vocabulary = Vocabulary::built_in());

/// What a thing is by its category and the name that its description gives it: the description's
/// where that is a sort of the category ("a bunk bed") or another thing altogether ("a canvas drop
/// cloth" for a picture).
KindPhrase own_name(std::string_view category, std::string_view description,
                    const Vocabulary& vocabulary = Vocabulary::built_in());

}  // namespace roomgen
