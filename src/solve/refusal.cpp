#include "refusal.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "propose.h"
#include "roomgen/base/text.h"
#include "trials.h"

namespace roomgen {

namespace {

// What is in the way of a thing where it would stand, by id; of one that comes along, with its own.
void add_blockers(const Layout& layout, const Object& standing, bool comes_along, std::set<std::string>& names) {
  const Layout::Candidate alone = layout.candidate(standing);
  const Footprint area = footprint(standing);
  const std::string whose = comes_along ? " (of its " + standing.id + ")" : "";
  if (!layout.fits_room(alone, area, bottom(standing))) names.insert("a wall, a door or a window" + whose);
  for (const auto& id : in_the_way(layout, standing)) names.insert(id + whose);
}

// What is in the way at the suggested place, turned as is suggested, else whichever way.
std::string blocked_by(const Layout& layout, const PlacementTask& task, const Vec2& location) {
  constexpr std::size_t most_named = 6;
  std::set<std::string> names;
  for (const double yaw : meant_yaws(layout, task.facing)) {
    Object standing = task.object;
    standing.position.head<2>() = location;
    standing.yaw = yaw;
    add_blockers(layout, standing, false, names);
    for (const auto& companion : companions_of(task, standing)) add_blockers(layout, companion, true, names);
  }
  std::vector<std::string> few(names.begin(), names.end());
  if (few.size() > most_named) few.resize(most_named), few.push_back("others");
  return join(few, ", ");
}

// What stands where it could stand otherwise, the most often first: looked at on a coarse grid.
std::string mostly_blocked_by(const Layout& layout, const Layout::Candidate& candidate) {
  constexpr std::size_t most_named = 3;
  const FootprintAt footprint_at(candidate.object);
  const double bottom = candidate.object.position.z();
  const Bounds2 box = bounds(layout.room().polygon);
  const double pitch = pitch_within_limit(0.25, layout.room().polygon, layout.wall_yaws().size(), most_looked_at);
  std::map<std::string, int> counts;
  for (double x = box.low.x() + pitch; x < box.high.x(); x += pitch)
    for (double y = box.low.y() + pitch; y < box.high.y(); y += pitch)
      for (const double yaw : layout.wall_yaws()) {
        const Footprint footprint = footprint_at({{x, y}, bottom, yaw});
        if (!layout.fits_room(candidate, footprint, bottom)) continue;
        for (const auto& thing : layout.things())
          if (layout.collides(candidate, footprint, bottom, thing)) ++counts[thing.object->id];
      }
  std::vector<std::pair<int, std::string>> order;
  for (const auto& [id, count] : counts) order.push_back({-count, id});
  std::sort(order.begin(), order.end());
  std::vector<std::string> names;
  for (const auto& [count, id] : order)
    if (names.size() < most_named) names.push_back(id);
  return join(names, ", ");
}

// What it would do, or suffer, at the suggested place, where the cheap tests pass.
std::string misfit_at(Layout& layout, const PlacementTask& task, const Vec2& location) {
  Layout::Candidate candidate = layout.candidate(task);
  for (const double yaw : meant_yaws(layout, task.facing)) {
    candidate.object = at_pose(task.object, {location, task.object.position.z(), yaw});
    if (!layout.fits(candidate, footprint(candidate.object), bottom(candidate.object))) continue;
    if (const auto verdict = layout.fits_exactly(candidate); !verdict)
      return "; at the suggested place " + misfit(layout, task.object, verdict);
  }
  return "";
}

// Why nothing more goes onto a thing.
Error refusal_on(const Layout& layout, const Object& object) {
  std::string why = "no place for " + object.id + " (" + size_text(object.size) + " m) on ";
  const Object* support = layout.find(object.on);
  if (!support) return {Error::Kind::not_found, why + (object.on.empty() ? "anything" : object.on) +
                                                    ": it is not in the room"};
  why += support->id + ": ";
  const auto& surfaces = layout.support_poses().surfaces(*support);
  const auto on_it = std::count_if(layout.objects().begin(), layout.objects().end(),
                                   [&](const Object& other) { return other.on == support->id; });
  if (surfaces.empty()) {
    why += "it has no level surface";
  } else if (!layout.support_poses().carries(object, *support)) {
    const Vec2 most = surfaces.front().box().size();
    why += "none of its surfaces is large and high enough; the largest is " +
           format_number(most.x(), 2) + " x " + format_number(most.y(), 2) + " m";
  } else if (on_it > 0) {
    why += "what stands there already (" + std::to_string(on_it) +
           (on_it == 1 ? " thing" : " things") + ") leaves no room";
  } else {
    why += "what stands around it is in the way";
  }
  return {Error::Kind::not_found, why};
}

}  // namespace

std::string misfit(const Layout& layout, const Object& object, const Layout::Verdict& verdict) {
  const auto things = layout.things();
  std::vector<std::string> ids;
  for (const std::size_t i : verdict.blamed)
    if (i < things.size()) ids.push_back(things[i].object->id);
  if (verdict.useless && *verdict.useless < things.size())
    return things[*verdict.useless].object->id + " could not be used or reached any more";
  if (verdict.useless)
    return object.id + " could not be used or reached" +
           (ids.empty() ? "" : ", for " + join(ids, ", ") + " would stand before it");
  if (!ids.empty()) return object.id + " would touch " + join(ids, ", ");
  return "nobody could walk from door to door";
}

std::vector<double> meant_yaws(const Layout& layout, const std::optional<double>& suggested) {
  if (suggested) return {*suggested};
  const auto walls = layout.wall_yaws();
  return {walls.begin(), walls.end()};
}

std::vector<std::string> in_the_way(const Layout& layout, const Object& standing) {
  const Footprint area = footprint(standing);
  std::vector<std::string> ids;
  if (standing.mount == Mount::surface) {
    for (const auto& other : layout.objects())
      if (other.on == standing.on && overlaps(area, footprint(other))) ids.push_back(other.id);
    return ids;
  }
  const Layout::Candidate alone = layout.candidate(standing);
  for (const auto& thing : layout.things())
    if (layout.collides(alone, area, bottom(standing), thing)) ids.push_back(thing.object->id);
  return ids;
}

Error refusal(Layout& layout, const PlacementTask& task, const Layout::Candidate& candidate,
              int candidates, int feasible) {
  if (task.object.mount == Mount::surface) return refusal_on(layout, task.object);
  std::string why = "no place for " + task.object.id + " (" + size_text(task.object.size) + " m): ";
  if (feasible == 0)
    why += "none of " + std::to_string(candidates) +
           " positions is inside the room and clear of doors, windows and other things";
  else
    why += "each of the " + std::to_string(feasible) +
           " clear positions would leave something unusable or out of reach";
  if (!task.location) {
    const std::string blockers = mostly_blocked_by(layout, candidate);
    if (!blockers.empty()) why += "; mostly in the way: " + blockers;
    return {Error::Kind::not_found, why};
  }
  constexpr double hardly = 0.02;  // metres
  const double behind = box_with_companions(task).high.y() - 0.5 * task.object.size.y();
  if (behind > hardly)
    why += "; its group reaches " + format_number(behind, 2) +
           " m behind it: put it so far off a wall";
  return {Error::Kind::not_found, why + why_not_there(layout, task)};
}

std::string why_not_there(Layout& layout, const PlacementTask& task) {
  const std::string blockers = blocked_by(layout, task, *task.location);
  const std::string in_the_way =
      blockers.empty() ? "" : "; in the way at the suggested place: " + blockers;
  return in_the_way + misfit_at(layout, task, *task.location);
}

bool needs_way_in(const Layout& layout, const PlacementTask& task) {
  return task.object.mount == Mount::floor && blocks_floor(task.object, layout.categories().get(task.object.category));
}

Error no_way_in(const PlacementTask& task) {
  return {Error::Kind::not_found, "no place for " + task.object.id + " (" + size_text(task.object.size) +
                                      " m): nobody gets into the room by its doors, even while it is empty; "
                                      "they need a clear way " + format_number(2 * person_radius, 1) + " m wide"};
}

}  // namespace roomgen
