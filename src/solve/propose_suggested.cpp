#include "proposals.h"

#include <algorithm>

namespace roomgen {

namespace {

// Straight at each thing that it shall look at.
void add_yaws_to_targets(const ProposalContext& context, const Vec2& from,
                         std::vector<double>& yaws) {
  for (const auto& relation : context.relations) {
    if (!is_looking_at(relation.kind) && relation.kind != RelationKind::around) continue;
    for (const auto& target : relation.targets)
      if ((target.center() - from).norm() > 1e-6)
        yaws.push_back(yaw_facing(target.center() - from) - relation.turn);
  }
}

}  // namespace

// Rings that lie the farther apart the wider they are.
std::vector<Vec2> offsets_about_suggestion(double reach) {
  constexpr double step = 0.01, growth = 0.5;
  constexpr int directions = 12;
  std::vector<Vec2> offsets = {Vec2::Zero()};
  for (double radius = step; radius < reach; radius += std::max(step, growth * radius))
    for (int i = 0; i < directions; ++i)
      offsets.push_back(rotated(Vec2(radius, 0.0), 2.0 * pi * i / directions));
  return offsets;
}

std::vector<double> suggested_yaws(const ProposalContext& context, const Vec2& at,
                                   std::vector<double> usual) {
  std::vector<double> yaws;
  if (context.suggestion.facing)
    yaws.push_back(*context.suggestion.facing);
  else
    yaws = std::move(usual);
  add_yaws_to_targets(context, at, yaws);
  return yaws;
}

void propose_suggested(const ProposalContext& context, std::vector<Pose>& poses) {
  if (!context.suggestion.location) return;
  const Vec2& location = *context.suggestion.location;
  const double height = mounting_height(context);
  const auto usual = useful_yaws(context);
  for (double yaw : usual) poses.push_back({location, height, yaw});
  if (!context.suggestion.binds) return;
  for (const Vec2& offset : offsets_about_suggestion(0.5))
    for (double yaw : suggested_yaws(context, location + offset, usual))
      poses.push_back({location + offset, height, yaw});
}

}  // namespace roomgen
