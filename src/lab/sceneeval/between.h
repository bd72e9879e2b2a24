#pragma once

#include <span>

#include "thing.h"

namespace roomgen::lab {

/// 1 for what stands, lies or hangs between two of the ends, seen from above: its centre between
/// theirs along the line through them and over neither; off that line by no more than half the
/// greater width of the two across it and half its own. SceneEval has no such function.
double between(const Thing& middle, std::span<const Thing> ends);

}  // namespace roomgen::lab
