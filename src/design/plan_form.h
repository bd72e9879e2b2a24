#pragma once

#include <string>

#include "roomgen/base/json.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::design {

/// The form of a model's answer for a whole room (plan_reply.h): the room with its surfaces, light and
/// openings, groups and single things; without `whole` that of an inventory alone (papers: RoomGen,
/// section 4.1).
const Json& plan_schema(bool whole);

/// The compositions that suit a kind of room and a wish, a line each with its parameters and parts;
/// then the names of all others.
std::string composition_lines(const std::string& room, const std::string& wish);

/// The kinds of things that are known, by name.
std::string kind_names(const KindTable& kinds);

}  // namespace roomgen::design
