#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/scene/object.h"
#include "roomgen/scene/requirement.h"
#include "roomgen/scene/room.h"

namespace roomgen {

namespace brief {
struct SaidWish;
}

/// What a room shall become.
struct PlanRequest {
  std::string prompt;
  std::uint64_t seed = 0;
  std::optional<Vec2> size;   ///< inner width and depth in metres, whatever the prompt says
  std::optional<Room> room;   ///< a floor plan that is given; then `size` is not used
  CancelToken cancel;
  /// Of the wish, PNG or JPEG files: photos of rooms, floor plans. A Reader adds what they show to
  /// the prompt, a line each, "Image 1: ..."; a model that plans sees them too.
  std::vector<std::string> pictures = {};
  /// What the prompt says, as a Reader (design/designer.h) read it; null, or of another prompt:
  /// rules read it.
  std::shared_ptr<const brief::SaidWish> said = {};
};

/// Objects of one kind that the room shall hold.
struct PlanItem {
  std::string category;
  std::string description;       ///< what retrieval looks for: "a white wooden desk"
  std::optional<Vec3> size;      ///< wanted width, depth, height in metres
  std::string asset;             ///< asset_key() of what it shall be; empty, or nobody has it: as said
  std::string left_out;          ///< why it is not placed after all; empty: it is
  int quantity = 1;
  bool for_each = false;         ///< so many on each of what `on` names, rather than in all
  bool varied = false;           ///< each a different asset rather than the same
  Mount mount = Mount::floor;
  std::string on;                ///< category or id of what carries it, for Mount::surface
  bool asked = false;            ///< the prompt named it
  std::vector<Relation> relations;   ///< fixed beforehand; else the designer chooses them per object
  std::optional<Vec2> location;      ///< suggested centre
  std::optional<double> facing;      ///< suggested yaw, radians
  /// Of what hangs, wanted metres from the floor: to its middle, or to its lower edge. What hangs from the
  /// ceiling reaches down so far.
  std::optional<double> height, bottom;
  Vec2 tilt = Vec2::Zero();          ///< AssetRef::tilt
  std::string group, part;           ///< what it is in a group of the plan; there a quantity of 0 is all of that part
  std::string serves;                ///< id of the requirement that it is there for
  /// Above 0 it only dresses the room: nobody asked for it, it is placed after the others, and what has a
  /// lower one is left out first.
  int spare = 0;
};

/// Things that stand together in one frame, that of the first of them (docs/groups.md): a composition of
/// data/compositions by name, or one of the plan's own. How its things look say the items of the group.
struct PlanGroup {
  std::string id;           ///< "dining-0"
  std::string composition;  ///< by name; with a definition it only says where the group likes to stand
  std::string definition;   ///< of a composition of its own, as in data/compositions: JSON on one line; may be empty
  std::set<std::string> without;  ///< parts of it that are left out
  std::map<std::string, std::variant<double, std::string>, std::less<>> parameters;
  std::set<std::string> fixed;       ///< parameters that somebody asked for: the group does not shrink by them
  std::vector<Relation> relations;   ///< of its anchor
  std::optional<Vec2> location;      ///< suggested, of its anchor
  std::optional<double> facing;      ///< suggested yaw of its anchor, radians
  bool asked = false;
  // Known once the group is completed; not in files:
  std::string anchor;                ///< its part
  std::map<std::pair<std::string, std::size_t>, int> units;  ///< by part and number, of groups within the group
};

/// A door, window or passage that a room shall have, and has no place yet.
struct WantedOpening {
  std::string kind;  ///< of data/openings.json: "french door"
  std::string wall;  ///< "wall-2", or a side of the compass ("north": +Y); empty: any
  std::optional<double> at;      ///< its middle: part of the way from the wall's first corner
  std::optional<double> offset;  ///< the same, metres from the wall's middle to its second corner
  std::optional<double> width, sill, head;  ///< metres; else as its kind has it
  std::string purpose;           ///< what it is for, in words

  bool operator==(const WantedOpening&) const = default;
};

/// What a designer makes of a prompt: the empty room and its inventory, in the order of placement.
struct Plan {
  std::string prompt;
  std::uint64_t seed = 0;
  Room room;
  std::vector<WantedOpening> openings;  ///< besides those of the room; settle() (design/designer.h)
  std::vector<PlanItem> items;
  std::vector<PlanGroup> groups;
  std::vector<std::string> excluded;  ///< categories that the prompt forbids
  std::vector<std::string> notes;     ///< what was assumed, for people
  std::vector<Requirement> requirements;  ///< the prompt's clauses, to be checked at the end
  std::vector<Heard> heard;               ///< what its words were taken for
  /// Numbers of a category from which its objects count; 0 unless given. In a dwelling, those that
  /// other rooms have.
  std::map<std::string, int, std::less<>> first_numbers;
};

/// One object of an item: "chair-2".
struct PlannedObject {
  std::string id;
  std::size_t item = 0;  ///< index into Plan::items
  int number = 0;        ///< of this item's quantity
};

/// All objects of a plan with their ids: the category in lower case, a hyphen, and a number that runs
/// over the plan.
std::vector<PlannedObject> planned_objects(const Plan& plan);

/// How many objects of exactly this category the plan holds.
int quantity_of(const Plan& plan, std::string_view category);

/// plan.json (docs/plan.schema.json).
Json to_json(const Plan& plan);
Result<Plan> plan_from_json(const Json& json, const std::string& source);
Result<Plan> read_plan(const std::filesystem::path& path);

/// What a designer makes of a prompt that asks for several rooms: a plan for each, in the order in
/// which they are furnished. Their objects are numbered through.
struct DwellingPlan {
  std::string prompt;
  std::uint64_t seed = 0;
  std::vector<Plan> rooms;
  std::vector<std::string> notes;  ///< what was assumed, for people
  std::vector<Requirement> requirements;  ///< of the dwelling as a whole; rooms have their own
  std::vector<Heard> heard;        ///< what the words of the whole prompt were taken for
};

/// Gives the objects of later plans other numbers than those of earlier ones ("bed-1"), wherever
/// a plan names them.
void number_through(DwellingPlan& plan);

/// plan.json of a dwelling (docs/plan.schema.json): "rooms" instead of "room" and "objects".
bool is_dwelling_plan(const Json& json);
Json to_json(const DwellingPlan& plan);
Result<DwellingPlan> dwelling_plan_from_json(const Json& json, const std::string& source);

}  // namespace roomgen
