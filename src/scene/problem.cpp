#include "roomgen/scene/problem.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "document_parts.h"
#include "file_limits.h"
#include "file_walls.h"
#include "room_part.h"
#include "roomgen/base/file.h"
#include "roomgen/base/text.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen {

namespace {

constexpr std::size_t max_tasks = 2000;
constexpr double on_wall_tolerance = 0.02;

// "office chair-0" is of category "office chair".
std::string category_of(const std::string& id) {
  const auto hyphen = id.rfind('-');
  if (hyphen == std::string::npos || hyphen + 1 == id.size()) return id;
  const bool numbered = id.find_first_not_of("0123456789", hyphen + 1) == std::string::npos;
  return numbered ? id.substr(0, hyphen) : id;
}

void read_opening(const JsonReader& json, OpeningType type, std::size_t number, Room& room) {
  json.allow_only({"segment", "sill", "head", "swing"});
  const bool window = type == OpeningType::window;
  Opening opening;
  opening.type = type;
  opening.id = std::string(name(type)) + "-" + std::to_string(number);
  opening.sill = json["sill"].number_or(window ? default_sill : 0.0, 0, 20);
  opening.head = json["head"].number_or(window ? default_window_head : default_door_head, 0, 20);
  const std::string swing = json["swing"].text_or("in");
  if (swing == "out") opening.swing = DoorSwing::out;
  else if (swing == "sliding") opening.swing = DoorSwing::sliding;
  else if (swing != "in") json["swing"].report("must be \"in\", \"out\" or \"sliding\"");

  const auto ends = json["segment"].elements(2);
  if (ends.size() != 2) return json["segment"].report("expected two points");
  const auto first = ends[0].numbers(2, -max_coordinate, max_coordinate);
  const auto second = ends[1].numbers(2, -max_coordinate, max_coordinate);
  const Vec2 a(first[0], first[1]), b(second[0], second[1]);
  for (std::size_t k = 0; k < room.polygon.size(); ++k) {
    const Segment wall = room.polygon.edge(k);
    if (distance(wall, a) > on_wall_tolerance || distance(wall, b) > on_wall_tolerance) continue;
    const double at_a = (a - wall.a).dot(wall.direction());
    const double at_b = (b - wall.a).dot(wall.direction());
    opening.wall = k;
    opening.from = std::min(at_a, at_b);
    opening.to = std::max(at_a, at_b);
    opening.hinge_at_from = at_a < at_b;
    room.openings.push_back(opening);
    return;
  }
  json["segment"].report("lies on no wall of the room");
}

PlacementTask read_task(const JsonReader& json) {
  json.allow_only({"name", "size", "constraints", "location", "facing", "category"});
  PlacementTask task;
  Object& object = task.object;
  object.id = lower(json["name"].text(200));
  object.category = lower(json["category"].text_or(category_of(object.id), 200));
  object.description = object.category;
  const Kind& category = KindTable::built_in().get(object.category);
  object.traits = category.traits;
  object.traits.round = false;  // the file gives a rectangle
  const bool with_height = json["size"].is_array() && json["size"].raw()->size() == 3;
  const auto size = json["size"].numbers(with_height ? 3 : 2, 0.01, 50.0);
  object.size = {size[0], size[1], with_height ? size[2] : default_object_height};
  SaidPlace said = read_said_place(json);
  object.relations = std::move(said.relations);
  task.location = said.location;
  task.facing = said.facing;
  return task;
}

void check_targets(const Problem& problem, const JsonReader& objects) {
  std::vector<std::string> ids;
  for (const auto& task : problem.tasks) {
    if (std::find(ids.begin(), ids.end(), task.object.id) != ids.end())
      return objects.report("there are two objects named \"" + task.object.id + "\"");
    ids.push_back(task.object.id);
  }
  for (const auto& task : problem.tasks)
    for (const auto& relation : task.object.relations) {
      if (relation.target.empty() || is_part_of_room(problem.room, relation.target)) continue;
      if (relation.target == task.object.id)
        return objects.report("\"" + task.object.id + "\" cannot be \"" + to_text(relation) + "\"");
      if (std::find(ids.begin(), ids.end(), relation.target) != ids.end()) continue;
      const std::string close = closest_name(relation.target, ids);
      return objects.report("\"" + task.object.id + "\": the target \"" + relation.target +
                            "\" is neither an object nor a part of the room" +
                            (close.empty() ? "" : "; did you mean \"" + close + "\"?"));
    }
}

}  // namespace

std::vector<Object> companions_of(const PlacementTask& task, const Object& standing) {
  std::vector<Object> placed;
  const Footprint frame = footprint(standing);
  for (const auto& companion : task.companions) {
    Object object = companion.object;
    object.position.head<2>() = frame.to_world(companion.position);
    object.yaw = wrap_angle(standing.yaw + companion.yaw);
    placed.push_back(with_rounded_pose(std::move(object)));
  }
  return placed;
}

Result<Problem> problem_from_json(const Json& json, const std::string& source) {
  JsonReader::Problems problems(source);
  const JsonReader root(json, problems);
  root.allow_only({"name", "room_type", "units", "room", "height", "doors", "windows", "objects"});
  if (root["units"].text_or("m") != "m") root["units"].report("only \"m\" is understood");

  Problem problem;
  problem.name = root["name"].text_or("");
  problem.room.type = root["room_type"].text_or("");
  problem.room.height = root["height"].number_or(default_room_height, 1.5, 20.0);
  const auto points = read_corners(root["room"]);
  auto polygon = make_polygon(points);
  if (!polygon) {
    root["room"].report(polygon.error().message);
    return *problems.first();
  }
  problem.room.polygon = *std::move(polygon);

  std::size_t number = 0;
  for (const auto& element : root["doors"].elements_or_none(100))
    read_opening(element, OpeningType::door, number++, problem.room);
  number = 0;
  for (const auto& element : root["windows"].elements_or_none(100))
    read_opening(element, OpeningType::window, number++, problem.room);
  for (const auto& element : root["objects"].elements(max_tasks))
    problem.tasks.push_back(read_task(element));

  if (auto status = check(problem.room); !status) root.report(status.error().message);
  check_targets(problem, root["objects"]);
  if (problems.first()) return *problems.first();
  const FileWalls walls(points, problem.room.polygon);
  for (auto& task : problem.tasks) walls.rename(task.object.relations);
  if (auto order = placement_order(problem.tasks); !order)
    return with_context(order.error(), source);
  return problem;
}

Result<Problem> read_problem(const std::filesystem::path& path) {
  auto text = read_file(path);
  if (!text) return text.error();
  auto json = parse_json(*text, path.string());
  if (!json) return json.error();
  return problem_from_json(*json, path.string());
}

Result<std::vector<std::size_t>> placement_order(const std::vector<PlacementTask>& tasks) {
  std::map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < tasks.size(); ++i) index[tasks[i].object.id] = i;
  std::vector<std::size_t> order;
  std::vector<bool> done(tasks.size(), false);
  const auto ready = [&](const Object& object) {
    const auto placed = [&](const std::string& id) {
      const auto found = index.find(id);
      return found == index.end() || done[found->second];
    };
    return placed(object.on) && std::all_of(object.relations.begin(), object.relations.end(),
                                            [&](const Relation& r) { return placed(r.target); });
  };
  while (order.size() < tasks.size()) {
    std::size_t next = 0;
    while (next < tasks.size() && (done[next] || !ready(tasks[next].object))) ++next;
    if (next == tasks.size()) {
      std::vector<std::string> waiting;
      for (std::size_t i = 0; i < tasks.size(); ++i)
        if (!done[i]) waiting.push_back("\"" + tasks[i].object.id + "\"");
      return Error{Error::Kind::invalid_input,
                   "the constraints of " + join(waiting, ", ") +
                       " depend on each other in a circle; remove one of them"};
    }
    done[next] = true;
    order.push_back(next);
  }
  return order;
}

}  // namespace roomgen
