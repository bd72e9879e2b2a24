#include "roomgen/lab/frames.h"

#include <Eigen/Geometry>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/json_lines.h"
#include "base/json_reader.h"
#include "base/relative_name.h"
#include "pose_json.h"
#include "roomgen/base/text.h"
#include "view/camera_json.h"

namespace roomgen::lab {

namespace {

using namespace detail;

constexpr double least_rate = 0.1, most_rate = 120.0;
constexpr double same_time = 1e-6;  // seconds
constexpr std::size_t most_frame_bytes = 512u << 20;
constexpr int most_side = 65536;

using Matrix34 = Eigen::Matrix<double, 3, 4>;

// Of the axes of OpenCV: x to the right, y down, z ahead.
Matrix34 camera_from_world(const Camera& camera) {
  Matrix34 pose;
  pose.leftCols<3>().row(0) = camera.right.transpose();
  pose.leftCols<3>().row(1) = -camera.up.transpose();
  pose.leftCols<3>().row(2) = -camera.backward.transpose();
  pose.col(3) = -(pose.leftCols<3>() * camera.origin());
  return pose;
}

Matrix34 world_from_object(const Object& object) {
  Matrix34 pose;
  pose.leftCols<3>() = Eigen::AngleAxisd(object.yaw, Vec3::UnitZ()).toRotationMatrix();
  pose.col(3) = object.position;
  return pose;
}

Matrix34 product(const Matrix34& a, const Matrix34& b) {
  Matrix34 c = a.leftCols<3>() * b;
  c.col(3) += a.col(3);
  return c;
}

Json pose_json(const Matrix34& pose) {
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row) {
    Json values = Json::array();
    for (int column = 0; column < 4; ++column) values.push_back(rounded(pose(row, column), 6));
    rows.push_back(values);
  }
  return rows;
}

Json object_json(const Object& object, std::size_t value, const SeenObject& seen, const Matrix34& from_world) {
  Json json = {{"id", object.id}, {"value", value}, {"category", object.category}, {"pixels", seen.pixels}};
  if (seen.pixels > 0) json["box_px"] = {seen.box.left, seen.box.top, seen.box.right, seen.box.bottom};
  const Matrix34 placed = world_from_object(object);
  json["size"] = {rounded(object.size.x()), rounded(object.size.y()), rounded(object.size.z())};
  json["world_from_object"] = pose_json(placed);
  json["camera_from_object"] = pose_json(product(from_world, placed));
  return json;
}

SeenObject seen_from_json(const JsonReader& reader) {
  SeenObject seen;
  seen.id = reader["id"].text();
  seen.pixels = static_cast<std::size_t>(reader["pixels"].integer_or(0, 0, 1LL << 40));
  if (seen.pixels == 0) return seen;
  const auto box = reader["box_px"].numbers(4, 0, most_side);
  if (box.size() == 4)
    seen.box = {static_cast<int>(box[0]), static_cast<int>(box[1]), static_cast<int>(box[2]), static_cast<int>(box[3])};
  return seen;
}

Result<FrameRecord> record_from(const Json& json, const std::string& source) {
  JsonReader::Problems problems{source};
  const JsonReader root(json, problems);
  FrameRecord record;
  record.frame.number = static_cast<std::size_t>(root["frame"].integer_or(-1, 0, 1 << 30));
  record.frame.keyframe = static_cast<std::size_t>(root["keyframe"].integer_or(-1, 0, 1 << 30));
  record.frame.time = root["time"].number(0.0, 1e9);
  record.frame.target = root["target"].text_or("");
  record.frame.pose = pose_from_json(root);
  const auto camera = root["camera"];
  record.width = static_cast<int>(camera["width"].integer_or(0, 1, most_side));
  record.height = static_cast<int>(camera["height"].integer_or(0, 1, most_side));
  record.picture = root["files"]["rgb"].text_or("");
  if (!record.picture.empty() && !stays_below(record.picture)) root["files"]["rgb"].report("leads outside the folder of the frames");
  for (const auto& object : root["objects"].elements(100000)) record.objects.push_back(seen_from_json(object));
  if (auto error = problems.first()) return *error;
  return record;
}

}  // namespace

Result<std::vector<TourFrame>> frames_of(const Tour& tour, double per_second) {
  if (!(per_second >= least_rate && per_second <= most_rate))
    return Error{Error::Kind::invalid_input, "frames: there must be 0.1 to 120 a second"};
  std::vector<std::string> target(tour.keyframes.size());
  for (const auto& view : tour.views)
    if (view.keyframe < target.size()) target[view.keyframe] = view.target;
  std::vector<TourFrame> frames;
  double due = 0.0;
  for (std::size_t k = 0; k < tour.keyframes.size(); ++k) {
    const auto& keyframe = tour.keyframes[k];
    const bool is_due = keyframe.time >= due - same_time;
    if (is_due) due = (std::floor((keyframe.time + same_time) * per_second) + 1.0) / per_second;
    if (is_due || !target[k].empty()) frames.push_back({frames.size(), k, keyframe.time, keyframe.pose, target[k]});
  }
  return frames;
}

Json to_json(const FrameRecord& record, const Scene& scene, const Camera& camera, const Json& files) {
  Json json = {{"frame", record.frame.number}, {"keyframe", record.frame.keyframe},
               {"time", rounded(record.frame.time)}};
  if (!record.frame.target.empty()) json["target"] = record.frame.target;
  add_pose(json, record.frame.pose);
  json["files"] = files;
  json["camera"] = camera_json(camera);
  const Matrix34 from_world = camera_from_world(camera);
  Json objects = Json::array();
  for (std::size_t k = 0; k < scene.objects.size(); ++k)
    objects.push_back(object_json(scene.objects[k], k + 1, record.objects[k], from_world));
  json["objects"] = objects;
  return json;
}

Result<std::vector<FrameRecord>> read_frames(const std::filesystem::path& path) {
  std::vector<FrameRecord> records;
  const auto take = [&](const Json& json, const std::string& source) -> Status {
    auto record = record_from(json, source);
    if (!record) return record.error();
    records.push_back(*std::move(record));
    return {};
  };
  if (auto status = read_json_lines(path, most_frame_bytes, take); !status) return status.error();
  return records;
}

}  // namespace roomgen::lab
