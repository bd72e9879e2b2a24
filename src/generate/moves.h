#pragma once

#include <span>
#include <vector>

#include "roomgen/generate/generate.h"

namespace roomgen {

/// What stands elsewhere, or otherwise turned, after than before, in the order of `before`.
std::vector<Move> moves_between(std::span<const Object> before, std::span<const Object> after);

/// Adds later moves to earlier ones: of what moved again, from where it first stood.
void add_moves(const std::vector<Move>& later, std::vector<Move>& moves);

}  // namespace roomgen
