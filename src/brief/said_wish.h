#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "brief_json.h"
#include "dwelling_prompt.h"
#include "roomgen/scene/plan.h"

namespace roomgen::brief {

/// A wish as somebody read it (PlanRequest::said): of several rooms each has its own brief.
struct SaidWish {
  std::string prompt;  ///< of which it is the reading
  Brief brief;         ///< concluded
  std::optional<SaidDwelling> dwelling = {};
  bool is_by_model = false;
  Json form = {};  ///< brief.json
};

/// What a request's prompt says: as it was read, else by rules.
Brief brief_of(const PlanRequest& request, const RoomKinds& kinds, const KindTable& table);
/// The reading of the request's prompt; null if rules are to read it.
const SaidWish* reading_of(const PlanRequest& request);

/// A wish read by rules, for one room or several.
SaidWish wish_by_rules(const std::string& prompt, const RoomKinds& kinds, const KindTable& table);

/// What a model answers about a wish: brief.json of one room, or with `rooms`.
struct WishReading {
  SaidWish wish;
  std::vector<std::string> problems = {}, repairs = {};  ///< as of BriefReading
  bool is_empty = false;  ///< nothing of it says anything of the wish
};
WishReading wish_from_json(const Json& json, const std::string& prompt, const RoomKinds& kinds,
                           const KindTable& table);

}  // namespace roomgen::brief
