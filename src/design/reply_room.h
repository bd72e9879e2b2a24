#pragma once

#include <string>
#include <vector>

#include "brief/brief.h"
#include "brief/room_kinds.h"
#include "roomgen/base/json.h"
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

}  // namespace roomgen::design
