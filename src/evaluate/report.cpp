#include "violations.h"

#include <algorithm>
#include <utility>

#include "collision/usability.h"
#include "scene/dwelling.h"
#include "scene/judgement.h"

namespace roomgen {

namespace {

constexpr double clearance_tolerance = 1e-3;
constexpr double ceiling_tolerance = 1e-3;

bool is_inside(const Object& object, const Room& room) {
  return contains(room.polygon, footprint(object)) && bottom(object) >= -ceiling_tolerance &&
         top(object) <= room.height + ceiling_tolerance;
}

// Does the object keep the clearance of this door or window free?
bool keeps_clear(const Object& object, const Kind& category, const Room& room,
                 const Opening& opening) {
  if (category.covers_window && !opening.is_entrance()) return true;
  if (object.traits.flat || object.mount == Mount::surface) return true;
  // What stands before a window may hide a little of it; what hangs keeps clear of it.
  const double hidden = object.mount == Mount::wall ? 0.0 : window_overlap;
  const double from = opening.is_entrance() ? 0.0 : opening.sill + hidden;
  if (top(object) <= from || bottom(object) >= opening.head) return true;
  const auto areas = clearances(room, opening);
  return std::none_of(areas.begin(), areas.end(), [&](const Footprint& area) {
    return overlaps(footprint(object), area, clearance_tolerance);
  });
}

void find_overlaps(const Scene& scene, Solids& solids, std::vector<Violation>& found) {
  Crowd crowd;
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Object &one = scene.objects[i], &other = scene.objects[j];
      if (!both_solid(one, other) || !boxes_overlap(one, other)) continue;
      if (crowd.is_full()) return found.push_back({Fault::too_crowded, one.id, ""});
      if (crowd.add(solids.overlap(one, other))) found.push_back({Fault::overlap, one.id, other.id});
    }
}

void find_blocked_openings(const Scene& scene, const KindTable& categories,
                           std::vector<Violation>& found) {
  for (const auto& opening : scene.room.openings)
    for (const auto& object : scene.objects)
      if (!keeps_clear(object, categories.get(object.category), scene.room, opening))
        found.push_back({opening.is_entrance() ? Fault::blocks_door : Fault::blocks_window,
                         object.id, opening.id});
}

void find_unusable(const Scene& scene, const KindTable& categories,
                   std::vector<Violation>& found) {
  const auto things = floor_things(scene.objects, categories);
  const OccupancyGrid map = make_occupancy_grid(scene.room, things);
  if (!map.doors_connected()) found.push_back({Fault::doors_apart, "", ""});
  for (const auto& thing : things)
    if (!is_usable(scene.room, things, thing, map))
      found.push_back({Fault::unusable, thing.object->id, ""});
}

}  // namespace

std::string_view name(Fault fault) {
  switch (fault) {
    case Fault::outside: return "outside";
    case Fault::overlap: return "overlap";
    case Fault::blocks_door: return "blocks door";
    case Fault::blocks_window: return "blocks window";
    case Fault::unusable: return "unusable";
    case Fault::doors_apart: return "doors not connected";
    case Fault::no_access: return "room without access";
    case Fault::too_crowded: return "too crowded to look for overlaps from here on";
  }
  return "";
}

std::string to_text(const Violation& violation) {
  return std::string(name(violation.fault)) + ": " + violation.object +
         (violation.other.empty() ? "" : " and " + violation.other);
}

int SceneReport::relations_held() const {
  return static_cast<int>(std::count_if(relations.begin(), relations.end(),
                                        [](const auto& verdict) { return verdict.judgement.held; }));
}

std::vector<Violation> violations(const Scene& scene, Solids& solids, const KindTable& categories) {
  std::vector<Violation> found;
  if (!scene.rooms.empty()) {
    for (const auto& part : parts_of(scene))
      for (auto& one : violations(part, solids, categories)) found.push_back(std::move(one));
    for (const auto& id : rooms_without_access(scene.rooms)) found.push_back({Fault::no_access, "", id});
    return found;
  }
  for (const auto& object : scene.objects)
    if (!is_inside(object, scene.room)) found.push_back({Fault::outside, object.id, ""});
  find_overlaps(scene, solids, found);
  find_blocked_openings(scene, categories, found);
  find_unusable(scene, categories, found);
  return found;
}

SceneReport examine(const Scene& scene, const ModelTable& models, const KindTable& categories) {
  Solids solids(models);
  SceneReport report;
  report.violations = violations(scene, solids, categories);
  for (const auto& part : parts_of(scene))
    for (auto& verdict : judge_scene(part, categories)) report.relations.push_back(std::move(verdict));
  return report;
}

}  // namespace roomgen
