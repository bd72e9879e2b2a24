#include <cmath>
#include <nlohmann/json.hpp>

#include "roomgen/tour/tour.h"

namespace roomgen {

namespace {

constexpr int degree_decimals = 3;

double file_degrees(double angle) { return rounded(degrees(angle), degree_decimals); }

Json point_json(const Vec3& point) { return {rounded(point.x()), rounded(point.y()), rounded(point.z())}; }

void add_pose(Json& json, const CameraPose& pose) {
  json["position"] = point_json(pose.eye);
  json["yaw_deg"] = file_degrees(pose.yaw);
  json["pitch_deg"] = file_degrees(pose.pitch);
}

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

}  // namespace

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

}  // namespace roomgen
