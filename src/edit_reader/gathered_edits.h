#pragma once

#include <map>

#include "clause.h"

namespace roomgen {

/// What the clauses of a text ask for so far, and what later ones make of earlier ones.
struct GatheredEdits {
  std::vector<edit::Operation> operations;

  void add(const Clause& clause);
  /// "a round one that seats six, in pale ash": looks said behind what comes are those with which it comes.
  bool fold_looks(const Clause& clause, const EditText& text);
  /// "add a lamp, in brass, on the desk": a place said behind what comes is where it comes.
  bool fold_place(const Clause& clause, const EditText& text);
  /// "and the plant too": the last operation, on other things.
  ReadClause likewise(const EditText& text, const Read<Ids>& what) const;
  /// "and vice versa", behind who goes where another stands.
  ReadClause vice_versa(const EditText& text, std::size_t end) const;
  /// Who goes to a place that is taken waits until it is free; two that take each other's place swap.
  std::vector<edit::Operation> settled() const;

 private:
  void drop_superseded(const Clause& clause);

  std::map<std::string, std::string> taken_over_;  ///< who goes where what stands
};

}  // namespace roomgen
