#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/scene/object.h"
#include "roomgen/scene/room.h"

namespace roomgen {

/// One object to be placed: everything but its pose, which is what a solver finds.
struct PlacementTask {
  Object object;                 ///< position and yaw mean nothing yet; relations are the constraints
  std::optional<Vec2> location;  ///< suggested centre
  std::optional<double> facing;  ///< suggested yaw, radians
  /// The suggestion is the word of a designer or a person: it is followed to the centimetre where the
  /// constraints allow, and binds later improvements.
  bool binding = false;
  /// Where what carries the object stood when that was said: the suggestion moves along with it.
  struct Stand {
    Vec2 position = Vec2::Zero();
    double yaw = 0.0;
  };
  std::optional<Stand> carrier_then;
  bool asked = false;            ///< somebody asked for it: what was merely added makes way
  int wishes = 0;                ///< so many of the relations, the first ones, were asked for
  /// Goes where its kind usually does, as far as the relations leave that open, where the solver knows
  /// how kinds are arranged.
  bool usual = false;
  bool anywhere = true;  ///< with `usual`: rather in an unusual place than in none
  int of_its_kind = 1;   ///< how many of its kind the room will hold
  /// Things that are placed together with the object, as one: each with its pose in the object's frame, its
  /// own pose meaning nothing but the height of its bottom. Their relations do not count.
  struct Companion {
    Object object;
    Vec2 position = Vec2::Zero();
    double yaw = 0.0;
  };
  std::vector<Companion> companions;
  std::string composition;  ///< as which all of them are arranged; empty: as the object's kind is
};

/// The companions where the object stands as it says, in their order.
std::vector<Object> companions_of(const PlacementTask& task, const Object& standing);

/// Input of the solver alone: a room and objects with known sizes and constraints, in file order.
struct Problem {
  std::string name;
  Room room;
  std::vector<PlacementTask> tasks;
};

inline constexpr double default_object_height = 0.9;

/// problem.json (docs/problem.schema.json): corners in either winding, door and window segments that
/// lie on a wall, objects with [width, depth] or [width, depth, height].
Result<Problem> problem_from_json(const Json& json, const std::string& source);
Result<Problem> read_problem(const std::filesystem::path& path);

/// Indices of the tasks so that each comes after the ones its constraints name, otherwise in file
/// order. Fails, naming the objects, when constraints depend on each other in a circle.
Result<std::vector<std::size_t>> placement_order(const std::vector<PlacementTask>& tasks);

}  // namespace roomgen
