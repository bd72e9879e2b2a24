#pragma once

#include "edit_text.h"

namespace roomgen {

/// The token behind words that ask for nothing: "our toddler keeps bumping his head on it"; `at` if they may ask
/// for something. Before anything is asked for (`at_first`) these may be words of which nothing is known.
std::size_t end_of_remark(const EditText& text, std::size_t at, bool at_first);

}  // namespace roomgen
