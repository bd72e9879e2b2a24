#pragma once

#include <optional>

#include "base/random.h"
#include "world.h"

namespace roomgen::lab::annealing {

/// Where a thing comes to stand when its attachments are given: what they leave open is drawn.
class Settler {
 public:
  Settler(World& world, Random& random) : world_(world), random_(random) {}

  /// Anywhere. Nothing if the attachments contradict each other or the thing has no room on what carries it.
  std::optional<Stance> anywhere(int article, std::span<const Attachment> attachments);
  /// As near to a point and yaw as the attachments allow, in the plane of what carries it.
  std::optional<Stance> near(int article, const Stance& wanted);

  /// Moves what is put up against a thing, and so on, along with it: the thing was at `before`. In order, so that
  /// all carriers are in place first. Returns everything that was moved, the thing included; nothing if something
  /// finds no place there.
  std::optional<SlotSet> carry(Slot root, const Stance& before, const Body& body_before);

 private:
  double place_along(const Track& track, const Object& object);
  std::optional<double> beside_another(const Track& track, const Object& object);
  Stance along_a_wall(int article, const Stance& stance);
  std::optional<Stance> against_another(int article, const Stance& stance);
  SupportPoses::Place any_place(std::span<const SupportSurface> surfaces);
  std::optional<Stance> on_carrier(int article, const Stance& wanted, bool anywhere);
  double level(int article, const Stance& stance);
  double usual_yaw();
  std::optional<Stance> carried(Slot slot, const Stance& moved);

  World& world_;
  Random& random_;
};

}  // namespace roomgen::lab::annealing
