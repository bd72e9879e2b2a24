#pragma once

#include "edit_text.h"

namespace roomgen {

/// Words that no one knows, and that are one letter away from just one word that edits are made of, or a name of what
/// is there, become that word: "chnage", "teh", "microwve".
void correct_spelling(EditText& text);

}  // namespace roomgen
