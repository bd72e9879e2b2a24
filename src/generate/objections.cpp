#include "objections.h"

#include <algorithm>
#include <cmath>

#include "roomgen/base/text.h"
#include "scene/judgement.h"

namespace roomgen {

namespace {

constexpr double far_away = 1.0;

// As near to a wall as makes no difference holds, though no report counts it; a beam from wall to
// wall hangs in the middle.
bool is_kept(RelationKind kind, const Judgement& judgement, const Object& standing,
             const Room& room) {
  constexpr double nearly_at_wall = 0.93;  // 0.07 m
  constexpr double off_walls = 0.3;
  if (kind == RelationKind::middle && standing.mount == Mount::ceiling)
    return distance_to_boundary(room.polygon, Vec2(standing.position.head<2>())) >= off_walls;
  return judgement.held || (kind == RelationKind::edge && judgement.degree > nearly_at_wall);
}

std::vector<std::string> lost_constraints(const Workplace& place, const PlaceAdvice& answer,
                                          const Object& standing) {
  Object said = standing;
  said.relations = answer.relations;
  const auto resolved = resolve(said, place.room, place.layout.objects(), place.categories);
  const Subject subject{footprint(standing), bottom(standing), top(standing)};
  std::vector<std::string> lost;
  for (std::size_t i = 0; i < resolved.size(); ++i)
    if (!is_kept(said.relations[i].kind, judge(resolved[i], subject, place.room), standing,
                 place.room))
      lost.push_back("\"" + to_text(said.relations[i]) + "\" does not hold");
  return lost;
}

}  // namespace

std::vector<std::string> objections_to(const Workplace& place, const PlaceAdvice& answer,
                                       const Object& standing) {
  if (answer.usual) return {};
  std::vector<std::string> objections = answer.lost;
  for (auto& lost : lost_constraints(place, answer, standing)) objections.push_back(std::move(lost));
  if (answer.location && !answer.spread) {
    const double away = (standing.position.head<2>() - *answer.location).norm();
    if (away > far_away)
      objections.push_back("it stands " + format_number(away, 2) + " m from the suggested place");
  }
  if (answer.yaw && standing.traits.front) {
    const double turned = std::abs(wrap_angle(standing.yaw - *answer.yaw));
    if (turned > facing_tolerance)
      objections.push_back("it looks " + format_number(degrees(turned), 0) +
                           " degrees away from the suggested facing");
  }
  return objections;
}

bool is_worth_asking(const Workplace& place, const PlaceAdvice& answer, const Object& standing) {
  constexpr double just_there = 0.05;
  auto objections = objections_to(place, answer, standing);
  const Vec2 at = standing.position.head<2>();
  if (answer.location && (at - *answer.location).norm() <= just_there) {
    Object said = standing;
    said.position.head<2>() = *answer.location;
    for (const auto& lost : lost_constraints(place, answer, said)) std::erase(objections, lost);
  }
  return !objections.empty();
}

}  // namespace roomgen
