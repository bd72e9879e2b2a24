#pragma once

#include <vector>

#include "assembly.h"
#include "connection_map.h"
#include "standing.h"
#include "validate.h"

namespace roomgen::create::detail {

/// What is wrong with an assembly, for the repairs.
struct Judgement {
  std::vector<std::vector<std::size_t>> contacts;
  std::vector<int> piece;  ///< of each part, numbered by size, the greatest first
  int pieces = 0;
  std::vector<int> level;  ///< contacts between the part and the ground; -1 when there is no way
  Standing standing;
  bool grounded = false, stable = false;
  std::vector<std::size_t> open;  ///< indices of firm links
  double gaps = 0.0;              ///< metres that are missing to close them
  int astray = 0;                 ///< feet that are not under what they carry
  double outside = 0.0;           ///< how far, in all

  bool perfect() const { return pieces == 1 && grounded && stable && open.empty(); }
  /// Less is better; a piece too many weighs more than an open link.
  double penalty() const;
  /// In none of the measures of Soundness worse.
  bool no_worse_than(const Judgement& other) const;
};

Judgement judge(const Assembly& assembly, const std::vector<Link>& links,
                const ValidateOptions& options);

/// What is missing for a link to be closed; 0 when it is.
double gap(const Assembly& assembly, const Link& link);
/// Between the sides of a link that is not to the floor: the nearest parts.
struct NearestPair {
  std::size_t one = 0, other = 0;
  NearestPoints points;
};
NearestPair nearest_pair(const Assembly& assembly, const Link& link);

Soundness soundness(const Assembly& assembly, const std::vector<Link>& links,
                    const Judgement& judgement, const ValidateOptions& options);

}  // namespace roomgen::create::detail
