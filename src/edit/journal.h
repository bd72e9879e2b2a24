#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "journal_entry.h"
#include "roomgen/base/result.h"

namespace roomgen {

/// What a journal's bytes hold.
struct JournalReading {
  std::vector<JournalEntry> entries;  ///< that are whole, in order; sequence numbers that lack are damaged lines
  std::size_t whole_bytes = 0;        ///< the rest is what a crash left; 0: the journal has not begun
  std::vector<std::string> notices;   ///< what is damaged, and where
};

/// Reads what is whole. A line whose checksum is wrong is skipped and told with its number and byte; what
/// stands behind the last whole line is left out. Fails for what is no journal, and for one that was written
/// by a newer version.
Result<JournalReading> read_journal(std::string_view bytes, const std::string& name);

/// The entries as lines; the first line of a journal stands before its first entry.
std::string journal_lines(std::span<const JournalEntry> entries, bool begins);

}  // namespace roomgen
