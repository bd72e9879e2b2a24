#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/vec.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/scene.h"
#include "roomgen/view/view.h"

namespace roomgen::lab {

/// How a camera is walked through a scene so that it sees each target once (docs/tours.md). Metres, radians.
struct TourOptions {
  std::vector<std::string> targets;        ///< ids of objects; none: all of them
  std::vector<std::string> first, last;    ///< of them, visited before and after all others, in this order
  bool flies = false;                      ///< only what is at the height of the eye is in the way
  double eye_height = 1.5;                 ///< above the floor, all the way
  double field_of_view = radians(90.0);    ///< from side to side
  int width = 160, height = 120;           ///< pixels of the pictures in which visibility is measured
  double least_distance = 0.3;             ///< of the eye from the target's footprint, on the floor
  double greatest_distance = 4.0;
  double least_hidden = 0.0;               ///< share of the target's pixels that others may hide
  double greatest_hidden = 0.3;
  int least_pixels = 16;                   ///< that a target must have when nothing hides it
  double agent_radius = 0.25;              ///< of the disc that is kept free of things and walls
  double steepest_pitch = radians(75.0);   ///< up or down
  double stray = radians(6.0);             ///< yaw and pitch are drawn from so far around the target's middle
  int samples = 320;                       ///< viewpoints that are tried for a target at most
  double speed = 0.6;                      ///< metres a second
  double turn_rate = radians(60.0);        ///< radians a second, of yaw and of pitch
  double pause = 0.5;                      ///< seconds before each target
  double keyframes_per_second = 10.0;      ///< at least
  std::uint64_t seed = 0;
  CancelToken cancel = {};
};

/// A bird's-eye tour: the camera flies 2 m above the floor (InfiniBench's height), or under a ceiling that is lower,
/// over all that is not as high, and may look straight down.
TourOptions birds_eye(const Scene& scene, TourOptions options = {});

/// What a text says of the camera.
struct TourWords {
  TourOptions options;                      ///< those given, with what the text asks for
  std::vector<std::string> understood;      ///< "eye height 1.2 m", for people
  std::vector<std::string> not_understood;  ///< sentences about the camera that say nothing known
};
/// Reads height of the eye, field of view, how much may be hidden, bird's-eye views, order and choice of targets out
/// of a text, a scene's prompt for instance (docs/tours.md); data/tour.json has the words.
TourWords read_tour_words(std::string_view text, const Scene& scene, const KindTable& kinds,
                          const TourOptions& options = {});

/// Where a camera is and looks: at yaw 0 towards -Y, as the fronts of objects do; a positive pitch is up.
struct CameraPose {
  Vec3 eye = Vec3::Zero();
  double yaw = 0.0;  ///< counter-clockwise, in (-pi, pi]
  double pitch = 0.0;
};

struct TourIntrinsics {
  int width = 0, height = 0;
  double field_of_view = 0.0;
};

/// The camera of a pose; larger pictures of the same proportions have other `width` and `height`.
Result<Camera> tour_camera(const CameraPose& pose, const TourIntrinsics& intrinsics);

/// A viewpoint that shows a target: all of its box is in the picture.
struct TourView {
  std::string target;
  CameraPose pose;
  std::size_t pixels = 0;        ///< that show it
  std::size_t pixels_alone = 0;  ///< that would if nothing hid it
  /// The best of those accepted: sqrt(pixels / all pixels of the picture) + 0.1 front - 0.05 way, where front is the
  /// cosine of the angle between the target's front and the direction to the eye (0 without a front) and way are the
  /// metres from the view before along the grid.
  double score = 0.0;
  double walked = 0.0;       ///< metres from the view before, along the straightened way
  std::size_t keyframe = 0;  ///< at which the camera is there

  double visible_share() const { return static_cast<double>(pixels) / static_cast<double>(pixels_alone); }
};

/// Between two keyframes the camera either walks straight on or turns where it stands, evenly.
struct TourKeyframe {
  double time = 0.0;  ///< seconds
  CameraPose pose;
};

/// A target that no view shows, and why.
struct UnseenTarget {
  enum class Cause {
    no_way_in,       ///< nobody of that width gets in by any door
    out_of_reach,    ///< no place to stand in the range of distances
    out_of_picture,  ///< from nowhere all of it is in the picture
    too_small,       ///< in the pictures that visibility is measured in
    hidden,          ///< too much or too little
  };
  std::string id;
  Cause cause = Cause::hidden;
  std::string reason;  ///< for people
};
std::string_view name(UnseenTarget::Cause cause);

struct Tour {
  std::uint64_t seed = 0;
  TourIntrinsics intrinsics;
  double agent_radius = 0.0;
  double least_hidden = 0.0, greatest_hidden = 0.0;
  std::vector<TourView> views;  ///< in the order in which they are visited
  std::vector<TourKeyframe> keyframes;
  std::vector<UnseenTarget> unseen;
};

/// From the first door that lets the agent in, again and again to the target that is nearest by the length of the
/// way (to the walkable place nearest to it) and not visited yet, to the best of the viewpoints that are drawn around
/// it and accepted. Ways are the shortest on a grid, pulled straight where that stays free; through the rooms of a
/// dwelling, whose inner doors stand open. Equal arguments give equal tours. Fails on options that make no sense, on
/// targets that the scene does not have, and if the eye is not below the ceiling.
Result<Tour> make_tour(const Scene& scene, const ModelTable& models, const KindTable& kinds, Renderer& renderer,
                       const TourOptions& options = {});

/// tour.json (docs/tour.schema.json).
Json to_json(const Tour& tour);
/// Reports the first problem with its JSON pointer.
Result<Tour> tour_from_json(const Json& json, const std::string& source);

}  // namespace roomgen::lab
