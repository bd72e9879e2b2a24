#pragma once

#include "clause.h"
#include "edit_roles.h"

namespace roomgen {

/// What an order asks for of things, by what its parts say and whatever the words around that: degrees, sides, looks,
/// a target to face, another thing instead.
ReadClause read_order_of(const EditText& text, const SpokenOrder& order, EditDeed deed, const Ids& things);
/// The floor, the walls or the ceiling, covered anew.
ReadClause read_cover(const EditText& text, const SpokenOrder& order);
/// What new things shall be like, said apart from their names: "…, a blue one", "…, 80 by 60".
std::string looks_apart(const EditText& text, const SpokenOrder& order);

}  // namespace roomgen
