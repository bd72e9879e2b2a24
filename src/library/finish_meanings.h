#pragma once

#include <map>
#include <string>

#include "attribute_words.h"

namespace roomgen {

/// What the words mean by which things are painted anew (data/finishes.json and the substances of
/// data/create/words.json): what can be painted can be judged. A tone is a colour near it; a substance a material
/// of that name in a colour near its own (what is dyed or painted: in any); a pattern a drawing of that name; gloss
/// a roughness; a shade ("weathered") a surface that was painted in it.
std::map<std::string, AttributeMeaning, std::less<>> finish_meanings();

}  // namespace roomgen
