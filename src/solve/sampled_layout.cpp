#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "roomgen/base/json.h"
#include "roomgen/solve/solve.h"
#include "scene/file_limits.h"

namespace roomgen {

namespace {

Json object_line(const Object& object, const Pose& pose) {
  return {{"id", object.id},
          {"position", {rounded(pose.position.x()), rounded(pose.position.y()), rounded(pose.bottom)}},
          {"yaw_deg", rounded(degrees(pose.yaw), 3)}};
}

}  // namespace

Scene things_of(const Problem& problem) {
  Scene scene;
  scene.prompt = problem.name;
  scene.room = problem.room;
  for (const auto& task : problem.tasks) scene.objects.push_back(task.object);
  return scene;
}

Scene with_layout(Scene scene, const SampledLayout& layout) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Pose& pose = layout.poses[i];
    scene.objects[i].position = {pose.position.x(), pose.position.y(), pose.bottom};
    scene.objects[i].yaw = pose.yaw;
  }
  return scene;
}

Json to_json(const Samples& samples, std::size_t index) {
  const SampledLayout& layout = samples.layouts[index];
  Json json = {{"index", index},
               {"seed", samples.seed},
               {"objects", Json::array()},
               {"held", layout.held},
               {"constraints", samples.constraints},
               {"score", rounded(layout.score)}};
  for (std::size_t i = 0; i < layout.poses.size(); ++i)
    json["objects"].push_back(object_line(samples.scene.objects[i], layout.poses[i]));
  return json;
}

Result<Scene> scene_of_layout(const Json& json, const Scene& things, const std::string& source) {
  JsonReader::Problems problems(source);
  const JsonReader root(json, problems);
  root.allow_only({"index", "seed", "objects", "held", "constraints", "score"});
  Scene scene = things;
  scene.objects.clear();
  for (const auto& line : root["objects"].elements()) {
    line.allow_only({"id", "position", "yaw_deg"});
    const std::string id = line["id"].text();
    const auto position = line["position"].numbers(3, -max_coordinate, max_coordinate);
    const double yaw = radians(line["yaw_deg"].number(-360, 360));
    const Object* thing = find_object(things, id);
    if (!thing) line["id"].report("there is no \"" + id + "\" among the things that are varied");
    else if (find_object(scene, id)) line["id"].report("\"" + id + "\" stands twice");
    if (problems.first()) return *problems.first();
    scene.objects.push_back(*thing);
    scene.objects.back().position = Vec3(position[0], position[1], position[2]);
    scene.objects.back().yaw = yaw;
  }
  if (problems.first()) return *problems.first();
  return scene;
}

}  // namespace roomgen
