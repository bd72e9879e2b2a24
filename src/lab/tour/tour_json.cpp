#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "pose_json.h"
#include "roomgen/lab/tour.h"

namespace roomgen::lab {

namespace {

using namespace detail;

constexpr int degree_decimals = 3;

double file_degrees(double angle) { return rounded(degrees(angle), degree_decimals); }

constexpr double farthest = 1e6;           // metres, and seconds
constexpr std::size_t most_keyframes = 1'000'000;

Json point_json(const Vec3& point) { return {rounded(point.x()), rounded(point.y()), rounded(point.z())}; }

Json intrinsics_json(const TourIntrinsics& intrinsics) {
  const double focal = 0.5 * intrinsics.width / std::tan(0.5 * intrinsics.field_of_view);
  return {{"model", "pinhole"},
          {"width", intrinsics.width},
          {"height", intrinsics.height},
          {"angle_deg", file_degrees(intrinsics.field_of_view)},
          {"focal_length_px", {rounded(focal, 6), rounded(focal, 6)}},
          {"principal_point_px", {0.5 * intrinsics.width, 0.5 * intrinsics.height}}};
}

Json view_json(const TourView& view) {
  Json json = {{"target", view.target}, {"keyframe", view.keyframe}};
  add_pose(json, view.pose);
  json["pixels"] = view.pixels;
  json["pixels_alone"] = view.pixels_alone;
  json["visible_share"] = rounded(view.visible_share());
  json["score"] = rounded(view.score);
  json["walked"] = rounded(view.walked);
  return json;
}

Json keyframe_json(const TourKeyframe& keyframe) {
  Json json = {{"time", rounded(keyframe.time)}};
  add_pose(json, keyframe.pose);
  return json;
}

TourIntrinsics intrinsics_from(const JsonReader& reader) {
  return {static_cast<int>(reader["width"].integer_or(0, 16, 4096)),
          static_cast<int>(reader["height"].integer_or(0, 16, 4096)), radians(reader["angle_deg"].number(10.0, 150.0))};
}

TourView view_from(const JsonReader& reader) {
  TourView view;
  view.target = reader["target"].text();
  view.keyframe = static_cast<std::size_t>(reader["keyframe"].integer_or(0, 0, most_keyframes));
  view.pose = pose_from_json(reader);
  view.pixels = static_cast<std::size_t>(reader["pixels"].integer_or(0, 0, 1LL << 40));
  view.pixels_alone = static_cast<std::size_t>(reader["pixels_alone"].integer_or(1, 1, 1LL << 40));
  view.score = reader["score"].number(-farthest, farthest);
  view.walked = reader["walked"].number(0.0, farthest);
  return view;
}

UnseenTarget unseen_from(const JsonReader& reader) {
  using Cause = UnseenTarget::Cause;
  UnseenTarget target{reader["target"].text(), Cause::hidden, reader["reason"].text()};
  const std::string cause = reader["cause"].text();
  for (const Cause one : {Cause::no_way_in, Cause::out_of_reach, Cause::out_of_picture, Cause::too_small, Cause::hidden})
    if (name(one) == cause) {
      target.cause = one;
      return target;
    }
  reader["cause"].report("expected no-way-in, out-of-reach, out-of-picture, too-small or hidden");
  return target;
}

}  // namespace

void detail::add_pose(Json& json, const CameraPose& pose) {
  json["position"] = point_json(pose.eye);
  json["yaw_deg"] = file_degrees(pose.yaw);
  json["pitch_deg"] = file_degrees(pose.pitch);
}

CameraPose detail::pose_from_json(const JsonReader& reader) {
  CameraPose pose;
  const auto eye = reader["position"].numbers(3, -farthest, farthest);
  if (eye.size() == 3) pose.eye = Vec3(eye[0], eye[1], eye[2]);
  pose.yaw = radians(reader["yaw_deg"].number(-360.0, 360.0));
  pose.pitch = radians(reader["pitch_deg"].number(-90.0, 90.0));
  return pose;
}

Result<Tour> tour_from_json(const Json& json, const std::string& source) {
  JsonReader::Problems problems{source};
  const JsonReader root(json, problems);
  if (root["format"].text_or("") != "roomgen-tour") root.report("expected a tour of `roomgen tour`");
  Tour tour;
  tour.seed = static_cast<std::uint64_t>(root["seed"].integer_or(0, 0, std::numeric_limits<long long>::max()));
  tour.intrinsics = intrinsics_from(root["camera"]);
  tour.agent_radius = root["agent_radius"].number(0.0, farthest);
  const auto range = root["hidden_range"].numbers(2, 0.0, 1.0);
  if (range.size() == 2) tour.least_hidden = range[0], tour.greatest_hidden = range[1];
  for (const auto& view : root["views"].elements(most_keyframes)) tour.views.push_back(view_from(view));
  for (const auto& keyframe : root["keyframes"].elements(most_keyframes))
    tour.keyframes.push_back({keyframe["time"].number(0.0, farthest), pose_from_json(keyframe)});
  for (const auto& target : root["unseen"].elements(most_keyframes)) tour.unseen.push_back(unseen_from(target));
  for (const auto& view : tour.views)
    if (view.keyframe >= tour.keyframes.size()) root["views"].report("a view names a keyframe that is not there");
  if (auto error = problems.first()) return *error;
  return tour;
}

std::string_view name(UnseenTarget::Cause cause) {
  switch (cause) {
    case UnseenTarget::Cause::no_way_in: return "no-way-in";
    case UnseenTarget::Cause::out_of_reach: return "out-of-reach";
    case UnseenTarget::Cause::out_of_picture: return "out-of-picture";
    case UnseenTarget::Cause::too_small: return "too-small";
    case UnseenTarget::Cause::hidden: return "hidden";
  }
  return "";
}

Json to_json(const Tour& tour) {
  Json views = Json::array(), keyframes = Json::array(), unseen = Json::array();
  for (const auto& view : tour.views) views.push_back(view_json(view));
  for (const auto& keyframe : tour.keyframes) keyframes.push_back(keyframe_json(keyframe));
  for (const auto& target : tour.unseen)
    unseen.push_back({{"target", target.id}, {"cause", name(target.cause)}, {"reason", target.reason}});
  return {{"format", "roomgen-tour"},
          {"version", 1},
          {"seed", tour.seed},
          {"camera", intrinsics_json(tour.intrinsics)},
          {"agent_radius", tour.agent_radius},
          {"hidden_range", {tour.least_hidden, tour.greatest_hidden}},
          {"views", views},
          {"keyframes", keyframes},
          {"unseen", unseen}};
}

}  // namespace roomgen::lab
