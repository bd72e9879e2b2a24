#pragma once

#include <optional>

#include "edit_text.h"

namespace roomgen {

/// Words that take back what was said just before them: ", sorry, no, …".
struct Correction {
  std::size_t begin = 0, end = 0;  ///< tokens, with the marks around the words
};
std::optional<Correction> correction_in(const EditText& text);

/// Texts in which what stands behind the correction takes the place of more and more of the words before it.
std::vector<EditText> corrected(const EditText& text, const Correction& correction);

}  // namespace roomgen
