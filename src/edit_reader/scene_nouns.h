#pragma once

#include <string>
#include <vector>

#include "edit_text.h"

namespace roomgen {

/// The things of the scene that a noun in the singular means by the words for them: "seat" the sofa and the chairs,
/// "settee" the sofa, "fire" the fireplace. What is there is known, so a word that fits one thing of it means that.
std::vector<std::string> things_by_meaning(const EditText& text, const std::string& noun);

}  // namespace roomgen
