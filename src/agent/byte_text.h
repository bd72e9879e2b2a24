#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace roomgen {

/// RFC 4648, section 4, padded.
std::string base64(std::string_view bytes);

bool is_utf8(std::string_view text);

/// The beginning of a text for a message: one line of at most `limit` bytes, with "…" when there
/// was more, spaces for control characters, '?' for bytes that are no UTF-8.
std::string excerpt(std::string_view text, std::size_t limit);

}  // namespace roomgen
