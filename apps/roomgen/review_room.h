#pragma once

#include <filesystem>

#include "designers.h"
#include "roomgen/edit_reader/understand.h"
#include "roomgen/library/library.h"

namespace roomgen::cli {

/// A room that was just written, looked at by the model that designed it.
struct RoomToReview {
  std::filesystem::path folder;
  const DesignerOptions& designer;
  const ComposedDesigner& composed;
  const AssetLibrary& library;
  int rounds = 2;
  bool has_pictures = true;
  int pixels = 1024;  ///< of those that are drawn anew
  CancelToken cancel;
};

/// Writes the room's files anew, with a line of trace.jsonl for each round, and changes `scene` to what they hold.
/// A model that gives no answer costs nothing but that: the room stays.
Result<std::vector<ReviewRound>> review_room(const RoomToReview& room, Scene& scene);

}  // namespace roomgen::cli
