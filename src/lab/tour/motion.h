#pragma once

#include "roomgen/lab/tour.h"

namespace roomgen::lab::detail {

/// A camera that walks and turns, one after the other, at the speeds of the options, and what it leaves behind.
class Motion {
 public:
  Motion(const TourOptions& options, const CameraPose& start);

  /// Turns towards the corners of the way and walks to each.
  void walk(const std::vector<Vec2>& way);
  void turn_to(double yaw, double pitch);
  void pause();

  const std::vector<TourKeyframe>& keyframes() const { return keyframes_; }

 private:
  const TourKeyframe& last() const { return keyframes_.back(); }
  void walk_to(const Vec2& place);
  template <typename PoseAt>
  void move(double seconds, const PoseAt& pose_at);

  double speed_, turn_rate_, pause_, rate_;
  std::vector<TourKeyframe> keyframes_;
};

}  // namespace roomgen::lab::detail
