#pragma once

#include <span>
#include <string>

#include "roomgen/base/json_fwd.h"
#include "roomgen/evaluate/score.h"

namespace roomgen {

/// A row whose room could not be scored.
struct Unscored {
  std::string id, reason;
};

/// Totals over all rooms and by difficulty, then each room with every verdict.
Json score_json(std::span<const RoomScore> scores, std::span<const Unscored> unscored = {});

/// A table of the measures, then for each room what fails and why.
std::string score_markdown(std::span<const RoomScore> scores,
                           std::span<const Unscored> unscored = {});

}  // namespace roomgen
