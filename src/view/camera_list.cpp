#include <algorithm>
#include <cctype>
#include <set>

#include "base/json_reader.h"
#include "camera.h"

namespace roomgen {

namespace {

constexpr std::size_t most_cameras = 10000, longest_camera_name = 64;
constexpr double farthest_camera = 1000.0;  // metres

// Names become names of files.
bool is_camera_name(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_';
  });
}

Vec3 point_of(const JsonReader& json) {
  const auto values = json.numbers(3, -farthest_camera, farthest_camera);
  return values.size() == 3 ? Vec3(values[0], values[1], values[2]) : Vec3(Vec3::Zero());
}

NamedCamera camera_of(const JsonReader& json) {
  json.allow_only({"name", "eye", "target", "angle_deg", "width", "height"});
  NamedCamera named{json["name"].text(longest_camera_name), {}};
  if (!is_camera_name(named.name)) json["name"].report("expected letters, digits, - and _");
  const auto side = [&](const char* key, int usual) {
    return static_cast<int>(json[key].integer_or(usual, min_picture_pixels, max_picture_pixels));
  };
  const double angle = json["angle_deg"].number_or(80.0, 1.0, 170.0);
  auto camera = pinhole_camera(point_of(json["eye"]), point_of(json["target"]), radians(angle), side("width", 640),
                               side("height", 480));
  if (camera)
    named.camera = *camera;
  else
    json.report(camera.error().message);
  return named;
}

}  // namespace

Result<std::vector<NamedCamera>> cameras_from_json(const Json& json, const std::string& source) {
  JsonReader::Problems problems(source);
  const JsonReader document(json, problems);
  document.allow_only({"format", "version", "cameras"});
  std::vector<NamedCamera> cameras;
  std::set<std::string> names;
  for (const auto& one : document["cameras"].elements(most_cameras)) {
    cameras.push_back(camera_of(one));
    if (!names.insert(cameras.back().name).second) one["name"].report("another camera has this name");
  }
  if (cameras.empty()) document["cameras"].report("expected a camera at least");
  if (problems.first()) return *problems.first();
  return cameras;
}

}  // namespace roomgen
