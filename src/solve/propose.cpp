#include "propose.h"

#include <algorithm>
#include <cmath>

#include "proposals.h"
#include "trials.h"
#include "ways.h"

namespace roomgen {

namespace {

// A picture or mirror hangs this far above what it is above.
constexpr double gap_above = 0.15;

// What hangs lower than the ceiling has something over it.
void keep_under_what_it_hangs_from(const ProposalContext& context, std::vector<Pose>& poses) {
  constexpr double off = 0.01, beside = 0.1;  // metres
  const double hook = top(context.task.object);
  if (hook > context.layout.room().height - off) return;
  std::erase_if(poses, [&](const Pose& pose) {
    return std::none_of(
        context.layout.things().begin(), context.layout.things().end(), [&](const FloorThing& one) {
          const Vec2 around = 2.0 * (one.footprint.half().array() + beside);
          return std::abs(roomgen::bottom(*one.object) - hook) < off &&
                 contains(Footprint(one.footprint.center(), around, one.footprint.yaw()),
                          pose.position);
        });
  });
}

void propose_above_targets(const ProposalContext& context, std::vector<Pose>& poses) {
  const Polygon& polygon = context.layout.room().polygon;
  const double bottom = context.task.object.position.z();
  const Bounds2 box = bounds(polygon);
  const double yaw = context.layout.wall_yaws().front();
  poses.push_back({0.5 * (box.low + box.high), bottom, yaw});
  if (context.suggestion.binds) propose_suggested(context, poses);
  for (const auto& relation : context.relations)
    for (const auto& target : relation.targets)
      if (takes_target(relation.kind)) poses.push_back({target.center(), bottom, target.yaw()});
  const double pitch = pitch_within_limit(0.25, polygon, 1);
  for (double x = box.low.x() + pitch; x < box.high.x(); x += pitch)
    for (double y = box.low.y() + pitch; y < box.high.y(); y += pitch)
      poses.push_back({{x, y}, bottom, yaw});
  keep_under_what_it_hangs_from(context, poses);
}

// A rug where its groups want it, and a little to and fro.
void propose_beneath(const ProposalContext& context, std::vector<Pose>& poses) {
  for (const auto& ideal : context.surroundings->beneath)
    for (double shift : {0.0, 0.2, 0.4, -0.2, -0.4})
      for (int turn = 0; turn < 4; ++turn)
        poses.push_back({ideal.to_world({0, -shift}), mounting_height(context),
                         wrap_angle(ideal.yaw() + turn * pi / 2)});
}

Company company_around(const ProposalContext& context, const Relation& relation,
                       const Object& target) {
  Company company;
  company.share = 2.0 * (target.size.x() + target.size.y()) / context.around_count;
  for (const auto& other : context.layout.objects()) {
    const auto& theirs = other.relations;
    if (other.id != context.task.object.id &&
        std::find(theirs.begin(), theirs.end(), relation) != theirs.end())
      company.positions.push_back(other.position.head<2>());
  }
  return company;
}

}  // namespace

Vec2 size_of(const ProposalContext& context) {
  return context.task.object.size.head<2>();
}

double mounting_height(const ProposalContext& context) {
  const Object& object = context.task.object;
  double height = object.position.z();
  if (object.mount != Mount::wall) return height;
  const Room& room = context.layout.room();
  for (const auto& relation : context.relations)
    if (relation.kind == RelationKind::above && relation.target_top < room.height)
      height = std::max(height, roomgen::mounting_height(Mount::wall, object.size.z(),
                                                         relation.target_top + gap_above, room));
  return height;
}

Vec2 turned_half(const Vec2& size, double relative_yaw) {
  const double c = std::abs(std::cos(relative_yaw)), s = std::abs(std::sin(relative_yaw));
  return 0.5 * Vec2(c * size.x() + s * size.y(), s * size.x() + c * size.y());
}

ProposalContext make_context(const Layout& layout, const PlacementTask& task,
                             std::vector<ResolvedRelation> relations, int around_count) {
  ProposalContext context{layout, task, std::move(relations), around_count,
                          suggestion_of(layout, task)};
  context.rest = Rest::of(layout, task.object);
  if (!task.companions.empty()) context.whole = box_with_companions(task);
  const Arrangement* arrangement = layout.arrangement_of(task);
  if (arrangement && task.object.mount != Mount::surface && (task.usual || !task.location)) {
    context.around_count = std::max(around_count, company_at_table(layout, task.of_its_kind));
    context.surroundings.emplace(layout, task, *arrangement, context.around_count);
  }
  for (const auto& relation : task.object.relations)
    if (relation.kind == RelationKind::around)
      if (const Object* target = layout.find(relation.target))
        context.companies.push_back(company_around(context, relation, *target));
  return context;
}

bool are_alike(const Object& object, const Pose& a, const Pose& b) {
  const double apart = std::clamp(0.5 * object.size.head<2>().minCoeff(), 0.2, 0.6);
  return (a.position - b.position).norm() < apart && std::abs(wrap_angle(a.yaw - b.yaw)) < 0.1;
}

bool wants(const ProposalContext& context, RelationKind kind) {
  return std::any_of(context.relations.begin(), context.relations.end(),
                     [&](const ResolvedRelation& relation) { return relation.kind == kind; });
}

int count_around(const Object& object, std::span<const Object> others) {
  const auto around =
      std::find_if(object.relations.begin(), object.relations.end(),
                   [](const Relation& relation) { return relation.kind == RelationKind::around; });
  if (around == object.relations.end()) return 1;
  return 1 + static_cast<int>(std::count_if(others.begin(), others.end(), [&](const Object& other) {
           return other.id != object.id && std::find(other.relations.begin(), other.relations.end(),
                                                     *around) != other.relations.end();
         }));
}

std::vector<double> useful_yaws(const ProposalContext& context) {
  const auto all = context.layout.wall_yaws();
  const Object& object = context.task.object;
  const bool square = std::abs(object.size.x() - object.size.y()) < 1e-6;
  if (object.traits.front || !context.task.companions.empty() || wants(context, RelationKind::edge) ||
      wants(context, RelationKind::corner))
    return {all.begin(), all.end()};
  // Half a turn changes nothing, a quarter turn neither if it is square or round.
  std::vector<double> yaws;
  for (double yaw : all) {
    const double period = square ? pi / 2 : pi;
    const bool known = std::any_of(yaws.begin(), yaws.end(), [&](double other) {
      return std::abs(std::remainder(yaw - other, period)) < 1e-6;
    });
    if (!known) yaws.push_back(yaw);
  }
  return yaws;
}

std::vector<Pose> propose_exact(const ProposalContext& context) {
  std::vector<Pose> poses;
  const Object& object = context.task.object;
  switch (object.mount) {
    case Mount::surface:
      if (const Object* support = context.layout.find(object.on))
        propose_on_surface(context, *support, poses);
      return poses;
    case Mount::ceiling:
      propose_above_targets(context, poses);
      return poses;
    case Mount::wall:
      propose_at_walls(context, poses);
      return poses;
    case Mount::floor:
      break;
  }
  propose_suggested(context, poses);
  if (!wants(context, RelationKind::middle)) propose_at_walls(context, poses);
  if (context.surroundings) propose_beneath(context, poses);
  propose_for_relations(context, poses);
  propose_with_companions(context, poses);
  return poses;
}

std::vector<Pose> propose_grid(const ProposalContext& context, double pitch,
                               const std::optional<Disc>& part) {
  std::vector<Pose> poses;
  if (context.task.object.mount != Mount::floor) return poses;
  const Bounds2 box = bounds(context.layout.room().polygon);
  const auto yaws = useful_yaws(context);
  if (!part) pitch = pitch_within_limit(pitch, context.layout.room().polygon, yaws.size());
  // One of the points is the middle of the room.
  const Vec2 middle = 0.5 * (box.low + box.high);
  const Vec2 steps = (0.5 * box.size() / pitch).array().floor();
  const int columns = static_cast<int>(steps.x()), rows = static_cast<int>(steps.y());
  for (int j = -rows; j <= rows; ++j)
    for (int i = -columns; i <= columns; ++i) {
      const Vec2 point = middle + pitch * Vec2(i, j);
      if (part && (point - part->center).norm() > part->radius) continue;
      for (double yaw : yaws) poses.push_back({point, mounting_height(context), yaw});
      if (!context.suggestion.binds) continue;
      for (double yaw : suggested_yaws(context, point, {}))
        poses.push_back({point, mounting_height(context), yaw});
    }
  return poses;
}

}  // namespace roomgen
