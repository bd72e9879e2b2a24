#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/result.h"
#include "roomgen/generate/generate.h"
#include "roomgen/generate/room_builder.h"
#include "roomgen/import/import.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/library/library.h"
#include "roomgen/scene/scene.h"
#include "roomgen/edit/operation.h"

namespace roomgen {

struct SessionOptions {
  bool look_only = false;  ///< no lock, and nothing is written; for history and differences
  /// Unlocked neighbours may move, as few and as little as can be, for what else finds no place.
  bool repair = true;
  SpareModels spare_models = {};  ///< where meshes come from that the library does not have
  LogSink log = {};
  double seconds = 60.0;    ///< most time of one edit; over it Error::Kind::limit, and nothing is changed
  CancelToken cancel = {};  ///< stops an edit: Error::Kind::cancelled, and nothing is changed
};

/// What was changed in another program.
struct HandEdits {
  std::vector<edit::Operation> operations;  ///< none: nothing moved
  std::vector<std::string> missing;         ///< ids of things that have no node any more
  std::vector<std::string> notes;           ///< nodes that cannot be followed, and why
};

/// What an edit did.
struct EditReport {
  std::vector<std::string> changes;  ///< in words: "floor-lamp-0 moved 0.4 m towards sofa-0"
  std::vector<std::string> added;    ///< ids of new objects
  std::vector<Move> repairs;         ///< neighbours that made way
  std::vector<std::string> broken;   ///< relations and requirements that held before, in words
  std::size_t state = 0;             ///< its number in the history
};

/// What a pose of an object would mean; nothing is changed.
struct Preview {
  bool feasible = false;
  std::string reason;               ///< why not
  Object object;                    ///< there, at the height at which it would stand
  double nearest = 0.0;             ///< metres to the nearest other thing or wall at its height
  std::vector<std::string> broken;  ///< relations that hold now and would not, in words
};

/// What the last edit was about: what "it" may mean. Ids of things that are still there.
struct Recall {
  std::vector<std::string> touched;
  std::vector<std::string> added;
};

/// A line of the history.
struct HistoryItem {
  std::size_t state = 0;   ///< its number; 0 for what made no state (undo, redo, a branch)
  std::size_t parent = 0;  ///< the state before; 0: none
  std::string branch, by, asked;
  bool is_current = false;
  bool is_undone = false;  ///< not on the way from the first state to the current one
};

/// Who asks, and in which words; both stand in the history.
struct Asker {
  std::string asked;
  std::string by = "person";
};

/// A finished room that people change. Every change is an entry of the journal beside scene.json, kept on
/// disk before the call returns (docs/editing.md); scene.json follows with save(). Undo and redo go to any
/// depth, and undoing everything gives the first bytes back.
///
///     auto session = Session::open("out/room/scene.json", *library, KindTable::built_in());
///     auto wishes = understand(*session, "put a floor lamp beside the sofa");
///     auto report = session->apply(wishes->operations, {"put a floor lamp beside the sofa"});
///     session->save();
///
/// A call either does all that it says or changes nothing. What nobody named keeps its pose to the bit, unless
/// EditReport::repairs names it. Nothing invalid (docs/constraints.md) comes in by an edit. Not for use by two
/// threads at once.
class Session {
 public:
  /// Fails with what is wrong in scene.json or the journal, and when another program edits the scene.
  /// `library` and `kinds` must outlive the session; meshes are read when the first edit needs them.
  static Result<Session> open(const std::filesystem::path& scene_file, const AssetLibrary& library,
                              const KindTable& kinds, SessionOptions options = {});
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  ~Session();

  const Scene& scene() const;
  /// The bytes of scene.json for this state.
  const std::string& text() const;
  /// The meshes of the scene.
  const ModelTable& models();
  const KindTable& kinds() const;
  Recall recall() const;
  /// What was found damaged or half done when the session was opened, and what became of it.
  const std::vector<std::string>& notices() const;

  /// How the nodes of a file differ from the scene: of scene.glb, after another program has moved, turned or
  /// scaled things in it. Nodes are matched as match_nodes() does.
  Result<HandEdits> compare(std::span<const SceneNode> nodes);
  /// All of them, in order, as one step of undo. not_found, saying what stands in the way and what would
  /// help, if one cannot be done.
  Result<EditReport> apply(std::span<const edit::Operation> operations, const Asker& asker = {});
  /// Could apply() carry them out? Nothing is changed.
  Status rehearse(std::span<const edit::Operation> operations);
  /// For drags: a pose is looked at, and the journal knows nothing of it.
  Result<Preview> preview(std::string_view object, const WantedPose& pose);

  /// How many steps were taken: 0 at the first and the last state.
  Result<std::size_t> undo(std::size_t steps = 1, const std::string& by = "person");
  Result<std::size_t> redo(std::size_t steps = 1, const std::string& by = "person");
  /// Goes to the branch of this name, which begins here, or at the given state, if there is none.
  Status branch(const std::string& name, std::optional<std::size_t> at = {}, const std::string& by = "person");
  const std::string& current_branch() const;
  std::vector<std::string> branches() const;

  /// All entries in the order in which they were made.
  std::vector<HistoryItem> history() const;
  /// What is different in a later state, in words. States are numbers of the history; the current one and
  /// the one before it unless said.
  Result<std::vector<std::string>> diff(std::optional<std::size_t> from = {}, std::optional<std::size_t> to = {}) const;

  /// Is scene.json what the journal says?
  bool is_saved() const;
  /// Writes scene.json, in one step.
  Status save();
  /// Somebody else wrote text() there, with other files of the room.
  void mark_saved();

 private:
  struct Impl;
  explicit Session(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// What is different between two scenes, in words.
std::vector<std::string> differences(const Scene& before, const Scene& after);

}  // namespace roomgen
