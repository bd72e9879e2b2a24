#include "propose.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "ways.h"

namespace roomgen {

namespace {

constexpr double along_wall_pitch = 0.10;
// Between small things side by side.
constexpr double apart = 0.006;

Vec2 size_of(const ProposalContext& context) {
  return context.task.object.size.head<2>();
}

// A picture or mirror hangs this far above what it is above.
constexpr double gap_above = 0.15;

// Of the bottom: what hangs above a thing clears its top as far as the room allows.
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

// The centres along a wall, measured from its start, at which a thing of this width is worth
// trying: regular steps, both ends, the middle, beside openings and neighbours, opposite targets.
std::vector<double> stations(const ProposalContext& context, std::size_t wall, double width) {
  const Room& room = context.layout.room();
  const Segment line = room.polygon.edge(wall);
  const double length = line.length();
  const double first = 0.5 * width + flush, last = length - 0.5 * width - flush;
  std::vector<double> result;
  if (last < first) {
    if (length + 1e-3 >= width) result.push_back(0.5 * length);
    return result;
  }
  for (double s = first; s < last; s += along_wall_pitch) result.push_back(s);
  const auto add = [&](double s) {
    if (s >= first - 1e-9 && s <= last + 1e-9) result.push_back(s);
  };
  const auto add_beside = [&](double low, double high) {
    add(low - 0.5 * width - flush);
    add(high + 0.5 * width + flush);
    add(0.5 * (low + high));
  };
  add(last);
  add(0.5 * length);
  if (context.suggestion.binds && context.suggestion.location)
    add((*context.suggestion.location - line.a).dot(line.direction()));
  for (const auto& opening : room.openings)
    if (opening.wall == wall) add_beside(opening.from, opening.to);
  const Vec2 along = line.direction(), inward = left_of(along);
  const double depth = size_of(context).y() + flush;
  for (const auto& thing : context.layout.things()) {
    double low = 1e300, high = -1e300, off = 1e300;
    for (const auto& corner : thing.footprint.outline()) {
      const double s = (corner - line.a).dot(along);
      low = std::min(low, s), high = std::max(high, s);
      off = std::min(off, (corner - line.a).dot(inward));
    }
    if (off < depth) add_beside(low, high);  // others stand clear of the wall
  }
  for (const auto& relation : context.relations)
    for (const auto& target : relation.targets) {
      if (!takes_target(relation.kind)) continue;
      add((target.center() - line.a).dot(line.direction()));
      if (relation.other)
        add((0.5 * (target.center() + relation.other->center()) - line.a).dot(line.direction()));
    }
  return result;
}

void propose_at_walls(const ProposalContext& context, std::vector<Pose>& poses) {
  const Vec2 size = size_of(context);
  const Polygon& polygon = context.layout.room().polygon;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Segment line = polygon.edge(k);
    const Vec2 inward = polygon.inward(k);
    const double yaw = yaw_facing(inward);
    for (double s : stations(context, k, size.x()))
      poses.push_back({line.a + s * line.direction() + (0.5 * size.y() + flush) * inward,
                       mounting_height(context), yaw});
  }
}

// The gaps to a target that are worth trying.
std::vector<double> useful_gaps(const ProposalContext& context, const ResolvedRelation& relation) {
  std::vector<double> gaps = {relation.gap_low + flush,
                              0.5 * (relation.gap_low + relation.gap_high),
                              relation.gap_high,
                              0.3,
                              0.6,
                              0.9,
                              1.2};
  if (context.task.object.mount == Mount::surface)
    return {relation.gap_low + apart, relation.gap_high, 0.01, 0.03, 0.06, 0.1, 0.2};
  if (context.layout.may_tuck(context.layout.categories().get(context.task.object.category),
                              context.layout.categories().get("table")))
    gaps.insert(gaps.end(), {-0.10, -0.20});
  return gaps;
}

// Half extents of a thing turned by `relative_yaw` against the target's axes.
Vec2 turned_half(const Vec2& size, double relative_yaw) {
  const double c = std::abs(std::cos(relative_yaw)), s = std::abs(std::sin(relative_yaw));
  return 0.5 * Vec2(c * size.x() + s * size.y(), s * size.x() + c * size.y());
}

// What the relations with one target leave open: on which sides of it, turned how against it.
struct Beside {
  bool sides[4] = {true, true, true, true};  // front, back, left, right
  bool turns[4] = {true, true, true, true};  // quarter turns of the yaw against the target's
  bool faces_target = false;
};

void keep_only(bool (&flags)[4], std::initializer_list<int> kept) {
  bool result[4] = {};
  for (int i : kept) result[i] = flags[i];
  std::copy(result, result + 4, flags);
}

Beside beside_target(const ProposalContext& context, const Vec2& target) {
  Beside beside;
  for (const auto& relation : context.relations) {
    if (!takes_target(relation.kind) || relation.targets.size() != 1 ||
        relation.targets.front().center() != target)
      continue;
    switch (relation.kind) {
      case RelationKind::in_front_of:
        keep_only(beside.sides, {0});
        break;
      case RelationKind::behind:
        keep_only(beside.sides, {1});
        break;
      case RelationKind::left_of:
        keep_only(beside.sides, {2});
        break;
      case RelationKind::right_of:
        keep_only(beside.sides, {3});
        break;
      case RelationKind::side_of:
        keep_only(beside.sides, {2, 3});
        break;
      case RelationKind::face_same_as:
        keep_only(beside.turns, {0});
        break;
      case RelationKind::face_opposite_to:
        keep_only(beside.turns, {2});
        break;
      case RelationKind::face_to:
        beside.faces_target = true;
        break;
      default:
        break;
    }
  }
  const Vec3& size = context.task.object.size;
  if (!context.task.object.traits.front && !wants(context, RelationKind::edge))
    keep_only(beside.turns, size.x() == size.y() ? std::initializer_list<int>{0}
                                                 : std::initializer_list<int>{0, 1});
  return beside;
}

// Beside the sides of the target that the relations allow, at several gaps, centred or flush with
// its ends, each way round.
void propose_beside(const ProposalContext& context, const ResolvedRelation& relation,
                    const Footprint& target, std::vector<Pose>& poses) {
  const Vec2 size = size_of(context);
  const auto gaps = useful_gaps(context, relation);
  const Beside beside = beside_target(context, target.center());
  constexpr int turn_to_face[4] = {2, 0, 3, 1};  // from the front, back, left, right
  for (int side = 0; side < 4; ++side)
    for (int turn = 0; turn < 4; ++turn) {
      if (!beside.sides[side] || !beside.turns[turn]) continue;
      if (beside.faces_target && turn != turn_to_face[side]) continue;
      const double yaw = wrap_angle(target.yaw() + turn * pi / 2);
      const Vec2 half = turned_half(size, turn * pi / 2);
      const int axis = side < 2 ? 1 : 0;
      const double sign = side == 0 || side == 3 ? -1.0 : 1.0;
      const double slide = target.half()[1 - axis] - half[1 - axis];
      for (double gap : gaps)
        for (double offset : {0.0, slide, -slide, 0.5 * slide, -0.5 * slide}) {
          Vec2 local;
          local[axis] = sign * (target.half()[axis] + gap + half[axis]);
          local[1 - axis] = offset;
          poses.push_back({target.to_world(local), mounting_height(context), yaw});
        }
    }
}

// Seats at the places of a table, for those that will come and for fewer, all looking at it.
void propose_seats(const ProposalContext& context, const ResolvedRelation& relation,
                   const Footprint& target, std::vector<Pose>& poses) {
  constexpr double farthest = 0.5, apart_at_least = 0.02;
  constexpr int usual_at_side = 4;
  const Vec2 size = size_of(context);
  const auto gaps = useful_gaps(context, relation);
  const auto seat = [&](const Vec2& outward, const Vec2& rim) {
    for (double gap : gaps)
      if (gap <= farthest)
        poses.push_back(
            {rim + (gap + 0.5 * size.y()) * outward, mounting_height(context), yaw_facing(-outward)});
  };
  if (target.round()) {
    const int directions = 4 * std::max(context.around_count, 2);
    for (int i = 0; i < directions; ++i) {
      const Vec2 direction = rotated({1, 0}, target.yaw() + 2 * pi * i / directions);
      seat(direction, target.center() + target.half().minCoeff() * direction);
    }
    return;
  }
  const int most = std::max(usual_at_side, (context.around_count + 1) / 2);
  for (int side = 0; side < 4; ++side) {
    const double length = 2 * target.half()[side < 2 ? 0 : 1];
    for (int count = 1; count <= most; ++count) {
      if (count > 1 && length / count < size.x() + apart_at_least) break;
      for (const auto& place : seat_places_at_side(target, side, count))
        seat(place.outward, place.rim);
    }
  }
}

// At several distances straight before the target, looking at it, and slantwise.
void propose_facing(const ProposalContext& context, const Footprint& target,
                    std::vector<Pose>& poses) {
  constexpr int directions = 16;
  const double reach = 0.5 * size_of(context).y();
  for (double distance : {0.4, 0.8, 1.2, 1.8, 2.4, 3.0})
    for (int i = 0; i < directions; ++i) {
      const Vec2 direction = rotated({1, 0}, target.yaw() + 2 * pi * i / directions);
      const double rim =
          std::abs(direction.dot(target.to_world({1, 0}) - target.center())) * target.half().x() +
          std::abs(direction.dot(target.to_world({0, 1}) - target.center())) * target.half().y();
      poses.push_back({target.center() + (rim + distance + reach) * direction,
                       mounting_height(context), yaw_facing(-direction)});
    }
}

void propose_above_targets(const ProposalContext& context, std::vector<Pose>& poses) {
  const Polygon& polygon = context.layout.room().polygon;
  const double bottom = context.layout.room().height - context.task.object.size.z();
  const Bounds2 box = bounds(polygon);
  const double yaw = context.layout.wall_yaws().front();
  poses.push_back({0.5 * (box.low + box.high), bottom, yaw});
  if (context.suggestion.binds && context.suggestion.location)
    poses.push_back({*context.suggestion.location, bottom, context.suggestion.facing.value_or(yaw)});
  for (const auto& relation : context.relations)
    for (const auto& target : relation.targets)
      if (takes_target(relation.kind)) poses.push_back({target.center(), bottom, target.yaw()});
  for (double x = box.low.x() + 0.25; x < box.high.x(); x += 0.25)
    for (double y = box.low.y() + 0.25; y < box.high.y(); y += 0.25)
      poses.push_back({{x, y}, bottom, yaw});
}

// Along the line between the two and a little aside of it, each way round.
void propose_between(const ProposalContext& context, const Footprint& a, const Footprint& b,
                     std::vector<Pose>& poses) {
  const Vec2 line = b.center() - a.center();
  if (line.norm() < 1e-9) return;
  const Vec2 along = line.normalized(), across = left_of(along);
  const double low = reach_along(a, along), high = line.norm() - reach_along(b, along);
  const double aside = std::max(reach_along(a, across), reach_along(b, across));
  for (double share : {0.5, 0.35, 0.65, 0.2, 0.8})
    for (double off : {0.0, 0.5, -0.5, 1.0, -1.0}) {
      const Vec2 at = a.center() + (low + share * (high - low)) * along + off * aside * across;
      for (int turn = 0; turn < 4; ++turn)
        poses.push_back({at, mounting_height(context),
                         wrap_angle(yaw_facing(across) + turn * pi / 2)});
    }
}

// Furniture on a rug.
void propose_standing_on(const ProposalContext& context, const Footprint& target,
                         std::vector<Pose>& poses) {
  for (double x : {-0.6, -0.3, 0.0, 0.3, 0.6})
    for (double y : {-0.6, -0.3, 0.0, 0.3, 0.6})
      for (int turn = 0; turn < 4; ++turn)
        poses.push_back({target.to_world(Vec2(x, y).cwiseProduct(target.half())),
                         mounting_height(context), wrap_angle(target.yaw() + turn * pi / 2)});
}

// A rug where its groups want it, and a little to and fro.
void propose_beneath(const ProposalContext& context, std::vector<Pose>& poses) {
  for (const auto& ideal : context.surroundings->beneath)
    for (double shift : {0.0, 0.2, 0.4, -0.2, -0.4})
      for (int turn = 0; turn < 4; ++turn)
        poses.push_back({ideal.to_world({0, -shift}), mounting_height(context),
                         wrap_angle(ideal.yaw() + turn * pi / 2)});
}

bool places_beside(RelationKind kind) {
  switch (kind) {
    case RelationKind::near:
    case RelationKind::next_to:
    case RelationKind::in_front_of:
    case RelationKind::behind:
    case RelationKind::left_of:
    case RelationKind::right_of:
    case RelationKind::side_of:
    case RelationKind::center_aligned:
    case RelationKind::aligned:
    case RelationKind::face_same_as:
    case RelationKind::face_opposite_to:
      return true;
    default:
      return false;
  }
}

void propose_for_relation(const ProposalContext& context, const ResolvedRelation& relation,
                          const Footprint& target, std::vector<Pose>& poses) {
  switch (relation.kind) {
    case RelationKind::around:
      propose_seats(context, relation, target, poses);
      break;
    case RelationKind::face_to:
      propose_facing(context, target, poses);
      break;
    case RelationKind::between:
      if (relation.other) propose_between(context, target, *relation.other, poses);
      break;
    case RelationKind::on:
      propose_standing_on(context, target, poses);
      break;
    case RelationKind::under:
    case RelationKind::above:
      for (double turn : {0.0, pi / 2})
        poses.push_back({target.center(), mounting_height(context), target.yaw() + turn});
      break;
    default:
      break;
  }
}

void propose_for_relations(const ProposalContext& context, std::vector<Pose>& poses) {
  std::vector<Vec2> seen;  // one round of poses beside a target serves all relations with it
  for (const auto& relation : context.relations) {
    if (!takes_target(relation.kind)) continue;
    for (const auto& target : relation.targets) {
      propose_for_relation(context, relation, target, poses);
      if (!places_beside(relation.kind) ||
          std::find(seen.begin(), seen.end(), target.center()) != seen.end())
        continue;
      seen.push_back(target.center());
      propose_beside(context, relation, target, poses);
    }
  }
}

// Beside those that stand on the same support already.
void propose_next_to_others(const ProposalContext& context, const Object& support,
                            std::vector<Pose>& poses) {
  const Vec2 size = size_of(context);
  for (const auto& thing : context.layout.things()) {
    if (thing.object->on != support.id) continue;
    const Footprint& other = thing.footprint;
    for (int turn : {0, 1}) {
      const Vec2 reach = other.half() + turned_half(size, turn * pi / 2) + Vec2::Constant(apart);
      for (const Vec2& side : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)})
        poses.push_back({other.to_world(side.cwiseProduct(reach)), 0.0,
                         wrap_angle(other.yaw() + turn * pi / 2)});
    }
  }
}

// Offsets from a suggested place: itself, and what still follows it where it is taken.
std::vector<Vec2> offsets_about_suggestion(double reach) {
  constexpr double step = 0.03;
  std::vector<Vec2> offsets;
  const int most = static_cast<int>(reach / step);
  for (int j = -most; j <= most; ++j)
    for (int i = -most; i <= most; ++i)
      if (const Vec2 offset = step * Vec2(i, j); offset.norm() < reach) offsets.push_back(offset);
  return offsets;
}

// Straight at each thing that it shall look at.
void add_yaws_to_targets(const ProposalContext& context, const Vec2& from,
                         std::vector<double>& yaws) {
  for (const auto& relation : context.relations) {
    if (relation.kind != RelationKind::face_to && relation.kind != RelationKind::around) continue;
    for (const auto& target : relation.targets)
      if ((target.center() - from).norm() > 1e-6)
        yaws.push_back(yaw_facing(target.center() - from));
  }
}

// The turns that a designer's word means at a place: the one that was said, else those that the
// constraints and the walls suggest.
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

// Exactly where it is suggested, and as near as makes no difference.
void propose_suggested(const ProposalContext& context, std::vector<Pose>& poses) {
  if (!context.suggestion.location) return;
  const Vec2& location = *context.suggestion.location;
  const double height = mounting_height(context);
  const auto usual = useful_yaws(context);
  for (double yaw : usual) poses.push_back({location, height, yaw});
  if (!context.suggestion.binds) return;
  for (const Vec2& offset : offsets_about_suggestion(0.10))
    for (double yaw : suggested_yaws(context, location + offset, usual))
      poses.push_back({location + offset, height, yaw});
}

std::vector<Pose> suggested_on(const ProposalContext& context, const Object& support) {
  if (!context.suggestion.location) return {};
  const Vec2& location = *context.suggestion.location;
  const bool has_front = context.task.object.traits.front;
  std::vector<double> turns;
  for (int turn = 0; turn < (has_front ? 4 : 2); ++turn)
    turns.push_back(wrap_angle(support.yaw + turn * pi / 2));
  std::vector<Pose> poses;
  for (double yaw : turns) poses.push_back({location, 0.0, yaw});
  if (!context.suggestion.binds) return poses;
  for (const Vec2& offset : offsets_about_suggestion(0.07))
    for (double yaw : suggested_yaws(context, location + offset, turns))
      poses.push_back({location + offset, 0.0, yaw});
  return poses;
}

// Wherever it can rest on the support, and of what means something the places where it can.
void propose_on_surface(const ProposalContext& context, const Object& support,
                        std::vector<Pose>& poses) {
  const SupportPoses& rests = context.layout.support_poses();
  const Object& object = context.task.object;
  for (const auto& rest : rests.everywhere(object, support))
    poses.push_back(pose_of(rest, support));
  std::vector<Pose> wished = suggested_on(context, support);
  propose_for_relations(context, wished);
  propose_next_to_others(context, support, wished);
  const Footprint area = footprint(support);
  std::vector<SupportPoses::Place> places;
  for (const auto& pose : wished)
    if (contains(area, pose.position))
      places.push_back({area.to_local(pose.position), wrap_angle(pose.yaw - support.yaw)});
  for (const auto& rest : rests.at(object, support, places))
    poses.push_back(pose_of(rest, support));
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

ProposalContext make_context(const Layout& layout, const PlacementTask& task,
                             std::vector<ResolvedRelation> relations, int around_count) {
  ProposalContext context{layout, task, std::move(relations), around_count,
                          suggestion_of(layout, task)};
  context.rest = Rest::of(layout, task.object);
  const Arrangement* arrangement = layout.arrangement_of(task.object);
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
  if (object.traits.front || wants(context, RelationKind::edge) ||
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
  return poses;
}

std::vector<Pose> propose_grid(const ProposalContext& context, double pitch,
                               const std::optional<Disc>& part) {
  std::vector<Pose> poses;
  if (context.task.object.mount != Mount::floor) return poses;
  const Bounds2 box = bounds(context.layout.room().polygon);
  const auto yaws = useful_yaws(context);
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
