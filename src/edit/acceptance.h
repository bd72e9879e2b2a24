#pragma once

#include <string>
#include <vector>

#include "placing.h"
#include "scene/resolved_relation.h"

namespace roomgen {

/// Which poses of a thing an aim lets through, as far as that can be told without meshes and ways: near enough,
/// off the edges of rugs, and all that is asked holds. For one layout, while it stays as it is.
class Acceptance {
 public:
  Acceptance(const Draft& draft, const Layout& layout, const Object& root, const Aim& aim);

  bool operator()(const Pose& pose);
  /// For people: what the poses lacked that came farthest; empty if none was refused.
  std::string why() const;

 private:
  enum class Lack { nothing, nearness, floor_beside_rugs, relations };

  Lack lack_of(const Pose& pose);
  bool is_near_enough(const Pose& pose) const;
  bool keeps_off_edges() const;
  bool holds_what_is_asked() const;

  const Draft& draft_;
  const Layout& layout_;
  const Aim& aim_;
  Object object_;  ///< at the pose that is asked about
  const Room& room_;
  std::vector<ResolvedRelation> asked_;
  Lack most_ = Lack::nothing;
};

}  // namespace roomgen
