#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/vec.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/relation.h"
#include "roomgen/scene/room.h"

/// Changes of a finished room, as values. Objects are named by their ids. Metres and radians; in JSON
/// (docs/operation.schema.json) metres and degrees.
namespace roomgen::edit {

/// New things. They get the next free numbers: after chair-1 comes chair-2.
struct Add {
  std::string category;     ///< a kind of the table, or a name that it knows
  std::string description;  ///< what the library looks for: "tall brass floor lamp"
  std::optional<Vec3> size = {};
  int count = 1;
  std::vector<Relation> relations = {};  ///< all must hold; none: where such things usually stand
  std::string room = {};                 ///< of a dwelling; else that of the first relation's target
  std::string program = {};  ///< that it is built by (docs/shapes.md); empty: the library finds it
  std::optional<Mount> mount = {};  ///< else as its relations say, or as its kind is put up

  bool operator==(const Add&) const = default;
};

/// Takes things out, with all that stands on them; `group`: and with the things that stand around them.
struct Remove {
  std::vector<std::string> objects;
  bool group = false;

  bool operator==(const Remove&) const = default;
};

/// To where these relations hold, with all that stands on it; without relations, where such things usually stand.
/// `group`: what stands around it comes along.
struct Move {
  std::string object;
  std::vector<Relation> relations;
  bool group = false;
  std::string room = {};  ///< of a dwelling; else that of the first relation's target, or its own

  bool operator==(const Move&) const = default;
};

/// Exactly there. On what is below; what stands on other things stays on `on` or finds what carries it.
struct Put {
  std::string object;
  Vec2 position = Vec2::Zero();
  std::optional<double> yaw = {};
  std::string on = {};

  bool operator==(const Put&) const = default;
};

/// By so much, in the scene's frame; up and down only what hangs. `group`: what stands around it comes along.
struct Shift {
  std::string object;
  Vec3 by = Vec3::Zero();
  bool group = false;

  bool operator==(const Shift&) const = default;
};

/// Where it stands, counter-clockwise from above; a little aside where there is no room for that. What stands around it
/// goes round with it if `group`, all exactly.
struct Turn {
  std::string object;
  double by = 0.0;
  bool group = false;

  bool operator==(const Turn&) const = default;
};

/// Turned to an object, an opening or a wall by its use: who sits at a desk looks there.
struct Face {
  std::string object, target;

  bool operator==(const Face&) const = default;
};

/// Two things change places.
struct Swap {
  std::string first, second;

  bool operator==(const Swap&) const = default;
};

/// Another thing in its place: another mesh of its kind, or as described. "a wider one" is wider than it is.
struct Replace {
  std::string object;
  std::string category = {};     ///< empty: the same
  std::string description = {};  ///< empty: any other
  std::optional<Vec3> size = {};  ///< about so large
  std::string program = {};       ///< that it is built by; empty: the library finds it

  bool operator==(const Replace&) const = default;
};

/// Stretched or squeezed to this width, depth and height.
struct Resize {
  std::string object;
  Vec3 size = Vec3::Ones();

  bool operator==(const Resize&) const = default;
};

/// Painted or covered anew: "navy velvet", "oak".
struct Recolor {
  std::string object;
  std::string looks;

  bool operator==(const Recolor&) const = default;
};

/// Repairs and improvements move it no more, or again; people's edits of a locked thing are refused.
struct Lock {
  std::vector<std::string> objects;
  bool locked = true;

  bool operator==(const Lock&) const = default;
};

/// What the floor, the walls, the accent wall or the ceiling of a room are covered with: "oak".
struct Cover {
  std::string part, looks;
  std::string room = {};  ///< of a dwelling

  bool operator==(const Cover&) const = default;
};

/// In what light a room shall be seen; what is not said stays.
struct Light {
  Lighting light;
  std::string room = {};  ///< of a dwelling

  bool operator==(const Light&) const = default;
};

/// Things are set out anew among all else, so that the same relations hold: "re-lay the seating corner". One
/// thing alone stands for its group.
struct Rearrange {
  std::vector<std::string> objects;

  bool operator==(const Rearrange&) const = default;
};

/// Several things at exact poses, all at once, each with what stands on it: what somebody set by hand.
struct Arrange {
  struct Spot {
    std::string object;
    Vec3 position = Vec3::Zero();  ///< bottom centre
    double yaw = 0.0;
    std::optional<Vec3> size = {};

    bool operator==(const Spot&) const = default;
  };
  std::vector<Spot> spots;

  bool operator==(const Arrange&) const = default;
};

/// A thing that was made of words is made anew with another form: "with a taller back".
struct Reform {
  std::string object;
  std::string words;

  bool operator==(const Reform&) const = default;
};

/// A room of one's own, not of a dwelling, gets another height, or one of its walls is moved outwards (inwards
/// below 0). What stands at the wall or hangs from it goes along.
struct Reshape {
  std::string wall = {};  ///< "wall-2"; empty: no wall moves
  double by = 0.0;
  std::optional<double> height = {};

  bool operator==(const Reshape&) const = default;
};

/// A door, window or passage more.
struct Open {
  std::string kind;             ///< of data/openings.json: "window", "double door"
  std::string wall = {};        ///< empty: where there is most room
  std::optional<double> at = {};  ///< of its middle, along the wall
  std::optional<double> width = {}, height = {}, sill = {};
  std::string room = {};        ///< of a dwelling

  bool operator==(const Open&) const = default;
};

/// An opening gets another place or another size; what is not said stays.
struct Refit {
  std::string opening;
  std::string wall = {};
  std::optional<double> at = {};  ///< of its middle, along the wall
  std::optional<double> width = {}, height = {}, sill = {};

  bool operator==(const Refit&) const = default;
};

/// Openings are walled up; curtains that hang before them go.
struct Close {
  std::vector<std::string> openings;

  bool operator==(const Close&) const = default;
};

/// Everything is as it was before the last edit.
struct Revert {
  bool operator==(const Revert&) const = default;
};

using Operation =
    std::variant<Add, Remove, Move, Put, Shift, Turn, Face, Swap, Replace, Resize, Recolor, Lock, Cover, Light,
                 Rearrange, Arrange, Reform, Reshape, Open, Refit, Close, Revert>;

/// {"do": "move", "object": "lamp-0", "relations": ["next to, bed-0"]}
Json to_json(const Operation& operation);
/// Errors name the member: "/object: …".
Result<Operation> operation_from_json(const Json& json, const std::string& source);
/// One operation, or a list of them.
Result<std::vector<Operation>> operations_from_json(const Json& json, const std::string& source);

}  // namespace roomgen::edit
