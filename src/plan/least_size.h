#pragma once

#include <functional>
#include <optional>

#include "roomgen/geometry/vec.h"

namespace roomgen::plan {

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
