#pragma once

#include "base/json_reader.h"
#include "roomgen/lab/program.h"

namespace roomgen::lab {

/// "room": what room the program asks for.
ProgramRoom read_room_wish(const JsonReader& json);
/// A number is a range of one.
Range read_program_range(const JsonReader& json, double low, double high);

}  // namespace roomgen::lab
