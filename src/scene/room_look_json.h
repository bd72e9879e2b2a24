#pragma once

#include <optional>
#include <string>

#include "base/json_reader.h"
#include "file_walls.h"
#include "roomgen/scene/room.h"

namespace roomgen {

// How a room looks, in its JSON form: materials, light, style and palette. What is of the right
// type and cannot be so is left out, with a remark.

/// Of a room whose polygon and openings are read.
void read_look(const JsonReader& json, const FileWalls& walls, Room& room);
void add_look(Json& json, const Room& room);

/// The members "hour", "sky", "level", "warmth" and "lamps", whatever else there is.
Lighting read_light(const JsonReader& json);
Json light_json(const Lighting& light);

/// A wall by its number, "wall-2", a side of the compass or "accent" as WallCover names it, as the
/// file counts; none, with a remark, if it is none of them.
std::optional<std::string> read_wall(const JsonReader& json);

/// Remarks on descriptions in "materials" that say neither a colour nor a stuff nor a pattern.
void remark_on_finishes(const JsonReader& materials);

/// A number, if there is one and it is within those bounds; a remark if it is not.
std::optional<double> read_within(const JsonReader& json, double low, double high);

}  // namespace roomgen
