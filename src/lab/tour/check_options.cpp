#include "check_options.h"

#include <algorithm>
#include <string>

#include "view/camera.h"

namespace roomgen::lab::detail {

namespace {

constexpr double under_ceiling = 0.05;  // metres from the eye to the ceiling at least
constexpr double least_frames = 1.0, most_frames = 120.0;
constexpr int most_samples = 100000;

Error bad_option(const std::string& what) { return {Error::Kind::invalid_input, "tour: " + what}; }

struct Rule {
  bool holds;
  const char* text;
};

std::string no_object(const Scene& scene, const std::string& id) {
  const std::string missing = "tour: the scene has no object " + id;
  if (scene.objects.empty()) return missing + ", nor any other";
  return missing + "; it has " + scene.objects.front().id + (scene.objects.size() > 1 ? " and others" : "") +
         ", as its file names them";
}

}  // namespace

double lowest_ceiling(const Scene& scene) {
  double lowest = rooms_of(scene)[0].height;
  for (const auto& room : rooms_of(scene)) lowest = std::min(lowest, room.height);
  return lowest;
}

// Comparisons are such that NaN meets none.
Status check_tour_options(const Scene& scene, const TourOptions& o) {
  const Rule rules[] = {
      {o.eye_height > 0 && o.eye_height <= lowest_ceiling(scene) - under_ceiling,
       "the eye must be above the floor and 5 cm below the ceiling or lower"},
      {o.field_of_view >= radians(10.0) && o.field_of_view <= radians(150.0),
       "the field of view must be 10 to 150 degrees"},
      {o.least_distance >= 0 && o.least_distance < o.greatest_distance && o.greatest_distance <= 100.0,
       "distances must be from 0 to 100 m, the least below the greatest"},
      {o.least_hidden >= 0 && o.least_hidden <= o.greatest_hidden && o.greatest_hidden <= 1.0,
       "the range of the hidden share must lie in [0, 1], its lower end first: nothing can be in an empty range"},
      {o.agent_radius >= 0.01 && o.agent_radius <= 10.0, "the agent's radius must be 0.01 to 10 m"},
      {o.steepest_pitch >= 0 && o.steepest_pitch <= radians(89.0), "the pitch must be at most 89 degrees"},
      {o.stray >= 0 && o.stray <= radians(90.0), "yaw and pitch must stray by at most 90 degrees"},
      {o.samples >= 1 && o.samples <= most_samples, "there must be 1 to 100000 samples for a target"},
      {o.least_pixels >= 1, "a target must have at least one pixel"},
      {o.speed >= 0.01 && o.speed <= 100.0, "the speed must be 0.01 to 100 metres a second"},
      {o.turn_rate >= radians(1.0) && o.turn_rate <= radians(3600.0),
       "the turn rate must be 1 to 3600 degrees a second"},
      {o.pause >= 0 && o.pause <= 60.0, "the pause must be at most 60 seconds"},
      {o.keyframes_per_second >= least_frames && o.keyframes_per_second <= most_frames,
       "there must be 1 to 120 keyframes a second"},
  };
  for (const auto& rule : rules)
    if (!rule.holds) return bad_option(rule.text);
  for (const int side : {o.width, o.height})
    if (auto status = check_picture_side(side); !status) return with_context(status.error(), "tour");
  for (const auto* ids : {&o.targets, &o.first, &o.last})
    for (const auto& id : *ids)
      if (!find_object(scene, id)) return Error{Error::Kind::not_found, no_object(scene, id)};
  return {};
}

}  // namespace roomgen::lab::detail
