#pragma once

#include <map>
#include <string>
#include <vector>

#include "composition/arrange.h"
#include "inventory.h"

namespace roomgen::plan {

/// The things of one part of a composition.
struct PartCount {
  std::string part, kind;
  Mount mount = Mount::floor;
  int count = 0;
  int spare = 0;
  Vec3 size = Vec3::Ones();  ///< of one, as the composition has it
};
using PartCounts = std::vector<PartCount>;  ///< the anchor's part first

/// A composition that a thing could be the anchor of, set for what is there.
struct Fit {
  const composition::Composition* composition = nullptr;
  composition::Values values;
  PartCounts counts;
  double gain = 0.0;  ///< what it is worth: the things that stand in their place by it
};

/// Things of a draft that are those of a part.
struct PartUse {
  std::size_t part = 0, draft = 0;
  int quantity = 0;
};

/// What is looked for: compositions for such a room and wish (in lower case).
struct FitRequest {
  std::string room, wish;
  std::string unit_of = {};  ///< only those with one thing of this kind, of which a block may have many
};

/// Which compositions (data/compositions) go with the things of a room. Remembers what compositions hold.
class Fitting {
 public:
  explicit Fitting(const KindTable& kinds) : kinds_(kinds) {}

  /// The one that gains most with the draft for its anchor; none where that is little.
  Fit best(const std::vector<Draft>& drafts, std::size_t anchor, const FitRequest& request);
  /// Whose things it takes, for one of it.
  std::vector<PartUse> uses(const Fit& fit, const std::vector<Draft>& drafts, std::size_t anchor) const;

  /// Whether it has one thing of the kind.
  bool is_unit(const Fit& fit, const std::string& category) const;
  /// A plain word is meant as what stands there: "stools" at a bar.
  bool is_plain_word_for(const Draft& draft, const std::string& kind) const;
  /// Of the kind, or called by the word that is usual for it: "table" for a dining table.
  bool is_kin(const std::string& category, const std::string& kind) const;

 private:
  const PartCounts& counts_of(const composition::Composition& composition, const composition::Values& values);
  Fit fit(const composition::Composition& composition, const std::vector<Draft>& drafts, std::size_t anchor);
  double gain_of(const PartCounts& counts, const std::vector<Draft>& drafts, std::size_t anchor) const;
  std::vector<int> shares(const PartCounts& counts, const std::vector<Draft>& drafts, std::size_t anchor) const;
  /// `left`: of each draft, of its share.
  std::vector<PartUse> uses_of(const PartCounts& counts, const std::vector<Draft>& drafts, std::size_t anchor,
                               std::vector<int>& left) const;
  bool is_told_within(const Draft& draft, const PartCounts& counts, const std::vector<Draft>& drafts,
                      std::size_t anchor) const;
  bool belongs(const Draft& draft, const PartCount& part) const;

  const KindTable& kinds_;
  std::map<std::string, PartCounts> known_;  ///< by composition and values
};

/// In no group yet, and without a place of its own.
inline bool is_free(const Draft& draft) {
  return draft.item.group.empty() && !draft.item.location && draft.item.quantity > 0;
}
/// Whether it takes its place together with the anchor; what is on others does so after them.
inline bool is_placed_with_anchor(Mount mount) { return mount != Mount::surface; }

}  // namespace roomgen::plan
