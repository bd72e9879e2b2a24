#pragma once

#include "draft.h"

namespace roomgen {

/// The thing with another width, depth and height, if such things may be so.
Result<Object> with_size(const Draft& draft, Object object, const Vec3& size);

/// A thing that is another one now (its mesh, its size) at its place, or a little aside; with all
/// that stood on it (`before`), as near as can be to where it did. The order of the scene's objects
/// stays.
Status put_changed(Draft& draft, const Cluster& before, Object changed);

/// A room as it will be, and what goes along with it.
struct RoomChange {
  Room room;
  std::set<std::string> along = {};  ///< ids of what stands at a wall that moves, or hangs from it
  Vec2 by = Vec2::Zero();            ///< how they go
};

/// Puts the changed room into the draft. What stood to the things that go along follows them; all
/// else keeps its pose, unless it would be where nothing may stand any more (docs/constraints.md,
/// "Valid"): then it moves as little as can be, with its relations. Whatever moved is in
/// Draft::repairs.
Status change_room(Draft& draft, const RoomChange& change);

/// The draft's requirements, checked on it as it stands now; those withdrawn stay so. Looks of
/// things that are as they were when the scene was opened keep their verdicts.
std::vector<RequirementVerdict> ledger_of(const Draft& draft);

/// Those of the requirements that were met and are not on the draft, in words; such as the edit
/// itself is about do not count.
std::vector<std::string> broken_requirements(const std::vector<RequirementVerdict>& before, const Draft& draft);

/// Relations of things that are still there which held before and do not on the draft, in words.
std::vector<std::string> broken_relations(const Scene& before, const Draft& draft);

/// Brings the draft's ledger up to date after all operations: what the edit asks for is added
/// (source "edit"), what it takes back is withdrawn, what went is counted no more, and everything
/// is checked anew. Returns what held before and does not now, in words.
std::vector<std::string> update_ledger(Draft& draft, const Scene& before);

}  // namespace roomgen
