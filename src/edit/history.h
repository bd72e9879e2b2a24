#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "roomgen/scene/scene.h"
#include "scene_files.h"
#include "timeline.h"

namespace roomgen {

/// Who wants a change, in which words, and what is done for it.
struct Deed {
  std::string asked;
  std::string by = "person";
  Json operations = nullptr;
};

/// A scene with all its past: the journal is the truth, scene.json follows it. Every call that changes
/// something has written it to the journal and synced that before it returns; then save() brings scene.json
/// up to date. After a failed write nothing more is written: open the files anew.
class History {
 public:
  /// Brings journal and scene.json together: what a crash left of the last line is dropped; a scene.json that
  /// is one entry behind is brought up to date; one that somebody changed by hand becomes a new entry. What
  /// was done of that is in notices(). With SceneAccess::look nothing is written.
  static Result<History> open(SceneFiles files, SceneAccess access = SceneAccess::edit);

  const SceneState& state() const { return state_; }
  const Timeline& timeline() const { return timeline_; }
  const std::vector<std::string>& notices() const { return notices_; }
  void add_notice(std::string notice) { notices_.push_back(std::move(notice)); }
  /// Was the state taken from scene.json just now, without a journal or since somebody changed it by hand?
  bool is_taken_from_file() const { return is_taken_from_file_; }
  /// Another state, or this one.
  Result<SceneState> state(std::size_t sequence) const { return timeline_.state(sequence, state_); }

  /// A new state after this one. A scene that does not differ is no new state.
  Status commit(const Scene& scene, const Deed& deed);
  /// How many steps were taken; fewer than asked for at the first or the last state.
  Result<std::size_t> undo(std::size_t steps, const std::string& by);
  Result<std::size_t> redo(std::size_t steps, const std::string& by);
  /// A new branch that goes on from a state (this one unless said), or the one of this name.
  Status branch(const std::string& name, std::optional<std::size_t> at, const std::string& by);

  /// Is scene.json what the journal says?
  bool is_saved() const { return is_saved_; }
  Status save();
  /// Somebody else wrote these bytes of state() to scene.json.
  void mark_saved() { is_saved_ = true; }

 private:
  History(SceneFiles files, SceneAccess access) : files_(std::move(files)), access_(access) {}
  Status begin(std::string scene_text);
  Status meet(const Result<std::string>& scene_text);
  Status take_over(std::string scene_text);
  Status drop_tail(std::size_t whole_bytes, std::size_t all_bytes);
  Status write(std::vector<JournalEntry> entries, bool begins = false);
  Status move_head(std::size_t to, const std::string& branch, const std::string& asked, const std::string& by);
  bool wants_snapshot(std::size_t more_bytes) const;

  SceneFiles files_;
  SceneAccess access_;
  Timeline timeline_;
  SceneState state_;
  std::vector<std::string> notices_;
  bool is_taken_from_file_ = false;
  std::size_t patched_bytes_ = 0;  ///< of edits since a state was written out
  bool is_saved_ = true;
  bool is_broken_ = false;
};

}  // namespace roomgen
