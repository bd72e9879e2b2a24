#pragma once

#include "item_kind.h"
#include "plan/inventory.h"
#include "roomgen/design/designer.h"

namespace roomgen::design {

/// What the room of an answer is called: "bedroom"; empty if it is not said.
std::string room_type_in(const Json& json);

/// The kind of room of this name, under that name.
brief::RoomKind kind_of_room(const std::string& type, const brief::RoomKinds& kinds);

/// The room of an answer with doors and windows: what the request says, else a polygon or a
/// rectangle that the answer gives, else one that takes `furniture` square metres of things.
Room read_reply_room(const Json& json, const PlanRequest& request, const brief::RoomKind& kind,
                     const brief::Brief& brief, double furniture,
                     std::vector<std::string>& repairs);

/// The part of an answer about the room: often its members stand beside it.
const Json& room_part(const Json& json);

/// The objects of an answer as drafts; draft i is mention i. What stands on others demands them.
/// The things of `groups`, a list or null, are among them, with the id of their group and what they
/// are called there. Notes what was cut, guessed or left out.
std::vector<plan::Draft> read_reply_items(const Json& objects, const Json& groups,
                                          const ItemLexicon& lexicon,
                                          std::vector<std::string>& repairs);

/// What a group of an answer is called: as it says, else by its number.
std::string reply_group_id(const Json& group, std::size_t number);
/// What a thing of a group is called there.
std::string reply_part_name(const Json& thing);

/// Where the designer that wrote an answer has a thing or the anchor of a group: "stands".
struct ReplyStands {
  std::optional<Vec2> location;
  std::optional<double> facing;  ///< yaw, radians
  bool at_wall = false;
};
ReplyStands read_reply_stands(const Json& value);

/// What an answer says of surfaces, light, style and palette, in the form of docs/room.schema.json,
/// and of openings; what cannot be so is noted and left open.
void read_reply_look(const Json& json, Room& room, std::vector<std::string>& repairs);
std::vector<WantedOpening> read_reply_openings(const Json& json, const Room& room,
                                               std::vector<std::string>& repairs);

}  // namespace roomgen::design
