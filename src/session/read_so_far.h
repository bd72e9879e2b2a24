#pragma once

#include "gathered_edits.h"

namespace roomgen {

/// What was read of an edit: what words behind it may speak of, and what it asks for.
struct ReadSoFar {
  EditText text;
  GatheredEdits gathered;
  std::vector<std::string> remarks;

  /// What the words of the text from `begin` on ask for.
  void take(const Clause& clause, std::size_t begin);
  /// All that words spoke of by name: "the table" behind them is one of these.
  void remember_names(std::size_t begin, std::size_t end);
  /// "our toddler bumps his head on the table": it is the table. Of several things it is the one that comes first, if
  /// all is about that; else it may be any.
  void speak_of(std::size_t begin, std::size_t end);
  /// Words that ask for nothing.
  void note_remark(std::size_t begin, std::size_t end);
};

}  // namespace roomgen
