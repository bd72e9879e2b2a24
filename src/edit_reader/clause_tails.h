#pragma once

#include "edit_text.h"

namespace roomgen {

/// Where words behind a clause end that ask for nothing themselves: "please", "so the kids can see it", "not the
/// desk", "for my daughter"; `at` if there are none.
std::size_t end_of_tail(const EditText& text, std::size_t at);

}  // namespace roomgen
