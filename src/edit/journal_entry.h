#pragma once

#include <cstddef>
#include <string>

#include "roomgen/base/result.h"

namespace roomgen {

inline constexpr std::size_t max_sequence = 1'000'000'000;

/// One entry of a journal (docs/journal.schema.json). Entries that make a state are known by their sequence
/// number ever after.
struct JournalEntry {
  enum class Kind {
    scene,     ///< a state as scene.json had it: the first one, and whenever somebody changed the file by hand
    edit,      ///< a state that an edit made of `parent`
    head,      ///< undo, redo, another branch: the branch goes to the state `to`
    snapshot,  ///< the whole of the state `to`, so that less has to be replayed
  };

  Kind kind = Kind::edit;
  std::size_t sequence = 0;  ///< from 1, rising by one
  std::size_t parent = 0;    ///< of states: the one before; 0: none
  std::size_t to = 0;        ///< of head and snapshot
  std::string branch;
  std::string by;     ///< who asked: "person", "model", a name
  std::string asked;  ///< in words
  std::string operations;     ///< of edits: what was done, as JSON; empty if nothing is said
  std::string before, after;  ///< SHA-256 of scene.json in the states `parent` and this one
  std::string patch;          ///< of edits: JSON (scene_patch.h), as text, which is a thirtieth of what values take
  std::string text;   ///< of scene and snapshot: the bytes of scene.json
};

/// One line, keys in a fixed order.
std::string journal_text(const JournalEntry& entry);
Result<JournalEntry> parse_entry(std::string_view text, const std::string& source);

}  // namespace roomgen
