#pragma once

#include <optional>
#include <vector>

#include "roomgen/library/library.h"
#include "roomgen/scene/scene.h"
#include "roomgen/edit/operation.h"

namespace roomgen::bench {

/// Whether an edit is possible with everything else fixed, found out by looking at every pose: a 0.05 m pitch and
/// the yaws of the walls on the floor, the same pitch along every wall at every height, all places where things
/// rest on others. Knows nothing of how the session looks for places; asks the same validity and the same meaning
/// of relations. What an edit leaves where it is (turns, replacements, new sizes) may give way by 0.5 m.
class ExhaustiveCheck {
 public:
  ExhaustiveCheck(const Scene& scene, const ModelTable& models, const AssetLibrary& library);

  /// The scene as it could be; nothing if the edit is not possible.
  std::optional<Scene> possible(const edit::Operation& operation);

  /// Poses that were refused, some of them, and how many of these `check` has nothing against.
  int sampled() const { return sampled_; }
  int too_strict() const { return too_strict_; }

 private:
  Scene with(const std::vector<Object>& objects) const;
  bool brings_no_fault(const std::vector<Object>& objects) const;

  const Scene& scene_;
  ModelTable models_;
  const AssetLibrary& library_;
  int sampled_ = 0, too_strict_ = 0;
};

}  // namespace roomgen::bench
