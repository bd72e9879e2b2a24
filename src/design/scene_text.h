#pragma once

#include <string>

#include "roomgen/design/designer.h"

namespace roomgen::design {

/// A scene in words, for language models that read coordinates in one of two frames: the scene's
/// own, or the paper's, x down from the top and y left from the right.
class SceneText {
 public:
  SceneText(const Room& room, bool paper_frame);

  /// What the axes of the picture and of all coordinates are.
  std::string frame() const;
  /// Type, size, height and corners.
  std::string room() const;
  /// A line for each wall, door and window.
  std::string parts() const;
  /// A line for each object; of its constraints it says which do not hold.
  /// Without `places` only what it is.
  std::string placed(const std::vector<Object>& objects, bool places = true) const;
  /// Sizes and centres, in one line.
  std::string free_floor(const std::vector<Bounds2>& parts) const;
  /// Constraints, place and facing of an answer, in one line.
  std::string answer(const PlaceAdvice& advice) const;
  std::string point(const Vec2& position) const;

 private:

  const Room& room_;
  bool paper_frame_;
  Bounds2 bounds_;
};

/// "1.6 x 2.1 x 0.9"
std::string size_text(const Vec3& size);

}  // namespace roomgen::design
