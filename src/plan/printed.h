#pragma once

#include <string>

#include "brief/brief.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::plan {

/// How a mention's things are described. What pictures show and signs say stands behind their name
/// in a prompt and before it here: "whale poster", "\"jazz\" neon sign".
std::string described_with_print(const brief::Brief& brief, const brief::Mention& mention,
                                 const KindTable& table);

/// Several pictures of which nothing says what they show.
bool are_pictures_of_anything(const brief::Mention& mention, const KindTable& table);

}  // namespace roomgen::plan
