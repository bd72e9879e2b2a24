#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "brief/brief.h"
#include "brief/room_kinds.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/vec.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::plan {

/// The kinds of which a room of this kind needs at least one to be what the prompt calls it (RoomKind::made_by);
/// none where the prompt does not want them, or wants nothing but what it names.
std::vector<std::string> needed_makers(const brief::RoomKind& kind, const brief::Brief& brief,
                                       const KindTable& table);

/// Of the makers of a kind those that its core brings: what such a room usually has.
std::vector<std::string> usual_makers(const brief::RoomKind& kind, const KindTable& table);

/// That a room has no place for any of these: Error::Kind::too_small.
Error no_place_for(const std::vector<std::string>& makers, const Room& room);

/// The same error with the least size that would do, instead of what it told of that before; none
/// was found: nothing.
Error with_least(const Error& too_small, const std::optional<Vec2>& least);
/// What an error of with_least() told.
std::optional<Vec2> told_least(const Error& too_small);

/// In which sides of rooms grow while the least size is looked for, metres.
inline constexpr double size_step = 0.1;
/// How many steps both sides grow at most, unless told otherwise.
inline constexpr int most_size_steps = 60;

/// The least width and depth, from `start` on, of which `works` says so: both sides grow alike, step by step,
/// until it does, then each goes back as far as it still does. So neither side can be a step shorter. Nothing if
/// no size does; `works` is asked for at most three times as many sizes as there are steps.
std::optional<Vec2> least_size(const Vec2& start, const std::function<bool(const Vec2&)>& works,
                               int most_steps = most_size_steps);

}  // namespace roomgen::plan
