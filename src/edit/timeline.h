#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "journal_entry.h"
#include "roomgen/base/json.h"
#include "roomgen/base/result.h"

namespace roomgen {

/// A scene at one moment: as a document, and the bytes of its scene.json.
struct SceneState {
  std::size_t sequence = 0;
  Json document;  ///< to_json(Scene)
  std::string text;
};

/// The bytes that an edit writes.
SceneState state_of(std::size_t sequence, Json document);
/// Those of a file, whoever wrote it. Fails where it is no sound scene.
Result<SceneState> state_of_text(std::size_t sequence, std::string text, const std::string& source);
std::string hash_of(const SceneState& state);

/// A name for a line of states.
struct Branch {
  std::size_t head = 0;  ///< the state it is at
  std::size_t tip = 0;   ///< the state that the last redo would come to
};

/// The states of a journal: a tree of which each is known by what differs from the one before. All that is
/// kept is what changed; any state is made again from the nearest that is written out.
class Timeline {
 public:
  /// The next entry of the journal.
  void add(JournalEntry entry);

  const std::map<std::string, Branch>& branches() const { return branches_; }
  const std::string& branch() const { return current_; }
  std::size_t head() const;
  std::size_t next_sequence() const { return entries_.empty() ? 1 : entries_.rbegin()->first + 1; }
  const std::map<std::size_t, JournalEntry>& entries() const { return entries_; }

  /// Is there such a state, or was there one whose entry is damaged?
  bool knows(std::size_t sequence) const;
  /// The state before; nothing for the first one, and where the entry is damaged.
  std::optional<std::size_t> before(std::size_t sequence) const;
  /// The next state on the way from one to a later one.
  std::optional<std::size_t> after(std::size_t sequence, std::size_t tip) const;
  /// SHA-256 of its scene.json; empty if no whole entry says it.
  std::string hash(std::size_t sequence) const;
  /// Where the head was before the last entry that moved it; nothing if it never was elsewhere.
  std::optional<std::size_t> head_before() const { return head_before_; }

  /// The state, made from `known` or from one that is written out, and compared with its hash. Fails, saying
  /// so, where damage lies between.
  Result<SceneState> state(std::size_t sequence, const SceneState& known) const;
  Result<SceneState> state(std::size_t sequence) const { return state(sequence, {}); }

 private:
  struct Step {
    std::size_t to = 0;
    const JournalEntry* edit = nullptr;
    bool backward = false;
  };
  /// How far a state is from the first one, and one far before it.
  struct Descent {
    std::size_t depth = 0, jump = 0;
  };
  Descent descent(std::size_t sequence) const;
  Descent below(std::size_t parent) const;
  std::size_t ancestor(std::size_t sequence, std::size_t depth) const;
  std::vector<Step> steps_from(std::size_t sequence) const;
  Result<SceneState> written(std::size_t sequence, const SceneState& known) const;
  bool is_written(std::size_t sequence, const SceneState& known) const;
  std::vector<Step> way_to(std::size_t sequence, const SceneState& known, std::size_t& start) const;

  std::map<std::size_t, JournalEntry> entries_;
  std::multimap<std::size_t, std::size_t> children_;        ///< edits and scenes by the state before
  std::map<std::size_t, Descent> descents_;                 ///< of the states that have one before
  std::map<std::size_t, std::size_t> snapshots_;            ///< entries by the state that they hold
  std::map<std::string, Branch> branches_;
  std::string current_;
  std::optional<std::size_t> head_before_;
};

}  // namespace roomgen
