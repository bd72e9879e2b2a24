#pragma once

#include <string>

#include "brief/brief.h"
#include "roomgen/base/json.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::design {

/// The form of a model's answer for a whole room (plan_reply.h): the room with its surfaces, light and
/// openings, groups and single things; without `whole` that of an inventory alone (papers: RoomGen,
/// section 4.1).
const Json& plan_schema(bool whole);

/// The compositions that suit the things of a wish and the kind of its room, a line each with its
/// parameters and parts; then some of the others by name. About 3 kB at most.
std::string composition_lines(const std::string& room, const brief::Brief& brief,
                              const std::string& wish);

/// The kinds of things that are known, by name.
std::string kind_names(const KindTable& kinds);

}  // namespace roomgen::design
