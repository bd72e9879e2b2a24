#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace roomgen {

/// A line of a journal carries its own checksum and is JSON all the same:
/// {"sum":"<16 hexadecimal digits>","entry":<body>} and a line feed, where the sum is the beginning of the
/// SHA-256 of the body's bytes.
std::string journal_line(std::string_view body);

/// The body of a line (without its line feed), if the line is whole.
std::optional<std::string_view> journal_body(std::string_view line);

/// A line of a journal as it was found.
struct JournalLine {
  std::size_t number = 1;  ///< counted from 1
  std::size_t begin = 0;   ///< first byte in the file
  std::string_view body;   ///< of the file's bytes; empty: the line is damaged
};

/// What of a journal's bytes is whole.
struct JournalLines {
  std::vector<JournalLine> lines;    ///< up to the last whole one, damaged ones between them included
  std::size_t whole_bytes = 0;       ///< the end of the last whole line: what follows was torn
};

/// Refers to the bytes. What follows the last whole line is what a crash left of a write that nobody
/// waited for any more.
JournalLines split_journal(std::string_view bytes);

}  // namespace roomgen
