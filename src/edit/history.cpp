#include "history.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/sha256.h"
#include "journal.h"
#include "scene_patch.h"

namespace roomgen {

namespace {

constexpr const char* first_branch = "main";
constexpr std::size_t longest_branch_name = 100;
// A state is written out when the changes since the last one fill so many times its bytes.
constexpr std::size_t patches_per_snapshot = 4;

JournalEntry scene_entry(const SceneState& state, std::size_t parent, const std::string& branch,
                         const std::string& asked) {
  JournalEntry entry;
  entry.kind = JournalEntry::Kind::scene;
  entry.sequence = state.sequence;
  entry.parent = parent;
  entry.branch = branch;
  entry.by = "file";
  entry.asked = asked;
  entry.after = hash_of(state);
  entry.text = state.text;
  return entry;
}

Status check_branch_name(const std::string& name) {
  const auto steers = [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; };
  const bool is_plain = !name.empty() && name.size() <= longest_branch_name && std::ranges::none_of(name, steers) &&
                        name.front() != '-';
  if (is_plain) return {};
  return Error{Error::Kind::invalid_input, "\"" + name + "\" is no name for a branch"};
}

}  // namespace

Result<History> History::open(SceneFiles files, SceneAccess access) {
  auto bytes = files.read_journal();
  if (!bytes) return bytes.error();
  auto reading = read_journal(*bytes, files.journal_name);
  if (!reading) return reading.error();
  History history(std::move(files), access);
  const auto scene_text = history.files_.read_scene();
  if (auto status = history.drop_tail(reading->whole_bytes, bytes->size()); !status) return status.error();
  history.notices_ = std::move(reading->notices);
  if (reading->entries.empty()) {
    if (!scene_text) return scene_text.error();
    if (auto status = history.begin(*scene_text); !status) return status.error();
    return history;
  }
  for (auto& entry : reading->entries) {
    if (entry.kind == JournalEntry::Kind::edit) history.patched_bytes_ += journal_text(entry).size();
    else if (entry.kind != JournalEntry::Kind::head) history.patched_bytes_ = 0;
    history.timeline_.add(std::move(entry));
  }
  if (auto status = history.meet(scene_text); !status) return status.error();
  return history;
}

Status History::drop_tail(std::size_t whole_bytes, std::size_t all_bytes) {
  if (whole_bytes == all_bytes || access_ == SceneAccess::look) return {};
  if (auto status = files_.cut(whole_bytes); !status) return status;
  return files_.sync();
}

Status History::begin(std::string scene_text) {
  auto state = state_of_text(1, std::move(scene_text), files_.scene_name);
  if (!state) return state.error();
  if (auto status = write({scene_entry(*state, 0, first_branch, "opened")}, true); !status) return status;
  state_ = *std::move(state);
  is_taken_from_file_ = true;
  return {};
}

// The journal and the file, of which either may be ahead of the other.
Status History::meet(const Result<std::string>& scene_text) {
  const auto head = timeline_.head();
  if (!scene_text && scene_text.error().kind != Error::Kind::not_found) return scene_text.error();
  const std::string found = scene_text ? sha256_hex(*scene_text) : "";
  if (scene_text && found == timeline_.hash(head)) {
    auto state = state_of_text(head, *scene_text, files_.scene_name);
    if (!state) return state.error();
    state_ = *std::move(state);
    return {};
  }
  const auto previous = timeline_.head_before();
  const bool is_behind = scene_text && previous && found == timeline_.hash(*previous);
  if (scene_text && !is_behind) return take_over(*scene_text);
  // What the file holds is the nearest to start from.
  auto known = is_behind ? state_of_text(*previous, *scene_text, files_.scene_name) : Result<SceneState>(SceneState{});
  if (!known) return known.error();
  auto state = timeline_.state(head, *known);
  if (!state) return with_context(state.error(), files_.journal_name);
  state_ = *std::move(state);
  is_saved_ = false;
  const bool is_written = access_ == SceneAccess::edit;
  notices_.push_back(files_.scene_name + (is_behind ? ": was one change behind the journal" : ": was not there") +
                     (is_written ? "; it is written again from the journal" : "; the next edit writes it again from the journal"));
  return {};
}

Status History::take_over(std::string scene_text) {
  auto state = state_of_text(timeline_.next_sequence(), std::move(scene_text), files_.scene_name);
  if (!state)
    return Error{state.error().kind, state.error().message + "; the journal still has the scene as it was: move " +
                                         files_.scene_name + " away, and the next command writes it again"};
  const auto entry = scene_entry(*state, timeline_.head(), timeline_.branch(), "changed by hand");
  if (auto status = write({entry}); !status) return status;
  state_ = *std::move(state);
  is_taken_from_file_ = true;
  notices_.push_back(files_.scene_name +
                     ": was changed by hand; that is a new entry of the journal (undo takes it back)");
  return {};
}

Status History::write(std::vector<JournalEntry> entries, bool begins) {
  if (is_broken_)
    return Error{Error::Kind::io, files_.journal_name + ": could not be written before; open the scene again"};
  if (entries.back().sequence > max_sequence)
    return Error{Error::Kind::limit, files_.journal_name + ": has no numbers for more entries; move it away, and its history begins anew"};
  if (access_ == SceneAccess::edit) {
    // So scene.json is never more than one entry behind, and what is not of the journal was made by hand.
    if (auto status = save(); !status) return status;
    is_broken_ = true;
    if (auto status = files_.append(journal_lines(entries, begins)); !status) return status;
    if (auto status = files_.sync(); !status) return status;
    is_broken_ = false;
  }
  for (auto& entry : entries) timeline_.add(std::move(entry));
  return {};
}

bool History::wants_snapshot(std::size_t more_bytes) const {
  return patched_bytes_ + more_bytes > patches_per_snapshot * state_.text.size();
}

Status History::commit(const Scene& scene, const Deed& deed) {
  SceneState next = state_of(timeline_.next_sequence(), to_json(scene));
  JournalEntry entry;
  entry.sequence = next.sequence;
  entry.parent = state_.sequence;
  entry.branch = timeline_.branch();
  entry.by = deed.by;
  entry.asked = deed.asked;
  if (!deed.operations.is_null()) entry.operations = json_line(deed.operations);
  entry.before = timeline_.hash(state_.sequence);
  entry.after = hash_of(next);
  const Json patch = scene_patch(state_.document, next.document);
  if (patch.empty()) return {};
  entry.patch = json_line(patch);
  std::vector<JournalEntry> entries = {entry};
  const std::size_t bytes = journal_text(entry).size();
  const bool with_snapshot = wants_snapshot(bytes);
  if (with_snapshot) {
    JournalEntry snapshot;
    snapshot.kind = JournalEntry::Kind::snapshot;
    snapshot.sequence = next.sequence + 1;
    snapshot.to = next.sequence;
    snapshot.branch = entry.branch;
    snapshot.text = next.text;
    entries.push_back(std::move(snapshot));
  }
  if (auto status = write(std::move(entries)); !status) return status;
  patched_bytes_ = with_snapshot ? 0 : patched_bytes_ + bytes;
  state_ = std::move(next);
  is_saved_ = false;
  return {};
}

Status History::move_head(std::size_t to, const std::string& branch, const std::string& asked,
                          const std::string& by) {
  auto state = timeline_.state(to, state_);
  if (!state) return with_context(state.error(), files_.journal_name);
  JournalEntry entry;
  entry.kind = JournalEntry::Kind::head;
  entry.sequence = timeline_.next_sequence();
  entry.to = to;
  entry.branch = branch;
  entry.by = by;
  entry.asked = asked;
  if (auto status = write({std::move(entry)}); !status) return status;
  is_saved_ = is_saved_ && state->text == state_.text;
  state_ = *std::move(state);
  return {};
}

Result<std::size_t> History::undo(std::size_t steps, const std::string& by) {
  std::size_t to = timeline_.head(), taken = 0;
  for (; taken < steps; ++taken) {
    const auto earlier = timeline_.before(to);
    if (!earlier) break;
    to = *earlier;
  }
  if (taken == 0) return taken;
  if (auto status = move_head(to, timeline_.branch(), "undo", by); !status) return status.error();
  return taken;
}

Result<std::size_t> History::redo(std::size_t steps, const std::string& by) {
  const auto tip = timeline_.branches().at(timeline_.branch()).tip;
  std::size_t to = timeline_.head(), taken = 0;
  for (; taken < steps; ++taken) {
    const auto later = timeline_.after(to, tip);
    if (!later) break;
    to = *later;
  }
  if (taken == 0) return taken;
  if (auto status = move_head(to, timeline_.branch(), "redo", by); !status) return status.error();
  return taken;
}

Status History::branch(const std::string& name, std::optional<std::size_t> at, const std::string& by) {
  if (auto status = check_branch_name(name); !status) return status;
  const auto known = timeline_.branches().find(name);
  const bool is_known = known != timeline_.branches().end();
  if (is_known && at)
    return Error{Error::Kind::invalid_input, "there is a branch \"" + name + "\" already; give another name"};
  const std::size_t to = is_known ? known->second.head : at.value_or(timeline_.head());
  if (is_known && name == timeline_.branch()) return {};
  return move_head(to, name, "branch " + name, by);
}

Status History::save() {
  if (is_saved_) return {};
  if (auto status = files_.write_scene(state_.text); !status) return status;
  is_saved_ = true;
  return {};
}

}  // namespace roomgen
