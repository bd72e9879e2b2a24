#include "frame_labels.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "roomgen/base/text.h"
#include "view/camera.h"
#include "view/layer_things.h"

namespace roomgen::lab::detail {

namespace {

constexpr double nearest_corner_depth = 0.05;  // metres before the camera, of corners that have a place in the picture

// A run of pixels of one object, column by column.
struct Run {
  std::size_t first, count;
};

std::vector<std::vector<Run>> runs_of(const Layers& layers, std::size_t objects) {
  std::vector<std::vector<Run>> runs(objects);
  const auto width = static_cast<std::size_t>(layers.camera.width), height = static_cast<std::size_t>(layers.camera.height);
  std::size_t at = 0;
  for (std::size_t x = 0; x < width; ++x)
    for (std::size_t y = 0; y < height; ++y, ++at) {
      const std::size_t number = layers.objects[y * width + x];
      if (number == 0 || number > objects) continue;
      auto& list = runs[number - 1];
      if (!list.empty() && list.back().first + list.back().count == at)
        ++list.back().count;
      else
        list.push_back({at, 1});
    }
  return runs;
}

// COCO counts pixels outside and inside by turns, outside first.
Json counts_of(const std::vector<Run>& runs, std::size_t pixels) {
  Json counts = Json::array();
  std::size_t at = 0;
  for (const auto& run : runs) {
    counts.push_back(run.first - at);
    counts.push_back(run.count);
    at = run.first + run.count;
  }
  if (at < pixels) counts.push_back(pixels - at);
  return counts;
}

// Where the object's box would be with a picture without edges; nothing if it reaches behind the camera.
std::optional<Bounds2> projected(const Camera& camera, const Object& object) {
  Bounds2 box;
  for (const auto& corner : box_corners(object)) {
    if (camera.distance(corner) < nearest_corner_depth) return std::nullopt;
    box.add(camera.pixel(corner));
  }
  return box;
}

// The share of the projected box beyond the picture's edges.
double truncation(const Camera& camera, const Object& object) {
  const auto box = projected(camera, object);
  if (!box) return 1.0;
  const Vec2 low = box->low.cwiseMax(Vec2::Zero()), high = box->high.cwiseMin(Vec2(camera.width, camera.height));
  const Vec2 inside = (high - low).cwiseMax(Vec2::Zero()), all = box->high - box->low;
  return 1.0 - inside.prod() / std::max(all.prod(), 1e-9);
}

std::string kitti_line(const Object& object, const SeenObject& seen, const Camera& camera) {
  const auto in_camera = [&](const Vec3& v) { return Vec3(camera.right.dot(v), -camera.up.dot(v), -camera.backward.dot(v)); };
  const Vec3 place = in_camera(object.position - camera.origin());
  const Vec2 front = front_direction(object.yaw);
  const Vec3 heading = in_camera({front.x(), front.y(), 0.0});
  const double turn = std::atan2(-heading.z(), heading.x());
  const double alpha = wrap_angle(turn - std::atan2(place.x(), place.z()));
  std::string type = object.category;
  std::replace(type.begin(), type.end(), ' ', '_');
  char text[256];
  std::snprintf(text, sizeof text, " %.2f 3 %.2f %d %d %d %d %.2f %.2f %.2f %.2f %.2f %.2f %.2f\n",
                truncation(camera, object), alpha, seen.box.left, seen.box.top, seen.box.right, seen.box.bottom,
                object.size.z(), object.size.x(), object.size.y(), place.x(), place.y(), place.z(), turn);
  return type + text;
}

}  // namespace

std::vector<SeenObject> seen_objects(const Layers& layers, std::size_t objects) {
  std::vector<SeenObject> seen(objects);
  for (std::size_t k = 0; k < objects; ++k) seen[k] = {layers.things[k].id, layers.things[k].pixels, {}};
  std::size_t at = 0;
  for (int y = 0; y < layers.camera.height; ++y)
    for (int x = 0; x < layers.camera.width; ++x, ++at) {
      const std::size_t number = layers.objects[at];
      if (number == 0 || number > objects) continue;
      PixelBox& box = seen[number - 1].box;
      if (box.right == 0) box = {x, y, x + 1, y + 1};
      box = {std::min(box.left, x), box.top, std::max(box.right, x + 1), y + 1};
    }
  return seen;
}

Json run_lengths(const Layers& layers, const std::vector<SeenObject>& seen) {
  Json list = Json::array();
  const auto runs = runs_of(layers, seen.size());
  for (std::size_t k = 0; k < seen.size(); ++k)
    if (seen[k].pixels > 0) list.push_back({{"value", k + 1}, {"counts", counts_of(runs[k], layers.objects.size())}});
  return list;
}

Json coco_json(const Scene& scene, const std::vector<FrameLabels>& frames) {
  Json images = Json::array(), annotations = Json::array(), categories = Json::array();
  const auto things = layer_things(scene);
  std::map<int, std::string> names;
  for (std::size_t k = 0; things && k < scene.objects.size(); ++k) names[(*things)[k].category_id] = (*things)[k].category;
  for (const auto& [number, category] : names) categories.push_back({{"id", number}, {"name", category}});
  for (const auto& [record, runs] : frames) {
    const std::size_t image = record.frame.number + 1;
    images.push_back({{"id", image}, {"file_name", record.picture}, {"width", record.width}, {"height", record.height}});
    for (const auto& run : runs) {
      const auto k = run["value"].get<std::size_t>() - 1;
      const SeenObject& seen = record.objects.at(k);
      const PixelBox& box = seen.box;
      annotations.push_back(
          {{"id", annotations.size() + 1}, {"image_id", image}, {"category_id", (*things)[k].category_id},
           {"bbox", {box.left, box.top, box.right - box.left, box.bottom - box.top}}, {"area", seen.pixels},
           {"iscrowd", 0}, {"segmentation", {{"size", {record.height, record.width}}, {"counts", run["counts"]}}},
           {"object", seen.id}});
    }
  }
  return {{"info", {{"description", "frames of a roomgen tour"}}}, {"images", images},
          {"annotations", annotations}, {"categories", categories}};
}

std::string kitti_text(const Scene& scene, const FrameRecord& record, const Camera& camera) {
  std::string text;
  for (std::size_t k = 0; k < scene.objects.size(); ++k)
    if (record.objects[k].pixels > 0) text += kitti_line(scene.objects[k], record.objects[k], camera);
  return text;
}

}  // namespace roomgen::lab::detail
