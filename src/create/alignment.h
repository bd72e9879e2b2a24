#pragma once

#include <vector>

#include "assembly.h"
#include "connection_map.h"
#include "handles.h"

namespace roomgen::create::detail {

class Trials;

/// A foot whose top is not under what it carries, and the way there, level.
struct Astray {
  std::size_t foot = 0, load = 0;
  double outside = 0.0;  ///< metres
  Wish wish;
};

std::vector<Astray> find_astray(const Assembly& assembly, const std::vector<Link>& links);

/// Moves feet inwards, copies alike, or what they carry over them.
void try_alignment(Trials& trials);

}  // namespace roomgen::create::detail
