#pragma once

#include <vector>

#include "roomgen/geometry/vec.h"
#include "roomgen/library/library.h"

namespace roomgen {

/// How alike two boxes are, axis by axis, in [0, 1]: the product over width, depth and height of a
/// term that is 1 for equal lengths and falls with their ratio. 0 when any axis is off by more than
/// a factor of about two: such a thing is not what was asked for, however well the others agree.
/// Lengths are compared after adding 0.1 m, so that a thick rug is still a rug.
double size_similarity(const Vec3& have, const Vec3& want);

/// The share of the wanted words that were found, each counting by its weight; 1 if none was
/// wanted.
struct WeightedWord {
  double weight = 1.0;
  double found = 0.0;  ///< 1: this word; less: one of its family (oak for wood)
};
double text_relevance(const std::vector<WeightedWord>& wanted);

/// What a match is judged by, each in [0, 1].
struct MatchTerms {
  double kind = 1.0;  ///< Vocabulary::fit
  double text = 1.0;  ///< text_relevance of the description
  double size = 1.0;  ///< size_similarity to the wanted box
  double mount = 1.0;
};
/// Their product, text and size weakened: being the right kind counts most. 0 if any but text is 0.
double match_score(const MatchTerms& terms);

/// How well a thing made for `have` serves when `want` is asked: 1 for the same, less where it can
/// be put there all the same (something low on a table top), else 0. `height` in metres.
double mount_fit(Mount have, Mount want, const std::vector<Mount>& also, double height);

/// Best first, what contradicts the query after all others, equal scores by library and id, at most `limit`.
void rank(std::vector<AssetMatch>& matches, std::size_t limit);

}  // namespace roomgen
