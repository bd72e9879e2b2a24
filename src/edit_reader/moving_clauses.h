#pragma once

#include "clause.h"

namespace roomgen {

/// Where a thing or a part of the room lies, as seen from an object.
Vec2 middle_of_target(const EditText& text, const Object& object, const std::string& target);

/// Each of the things by so much, or nearer to what it says, or farther from it.
ReadClause read_shift(const EditText& text, const Ids& ids, const Shifting& how, bool group);

/// "to face each other", "side by side against the wall"
std::optional<ReadClause> read_mutual(const EditText& text, const Read<Ids>& what);
/// "with its back to the bed": the front away from it.
std::optional<ReadClause> read_facing_away(const EditText& text, const Read<Ids>& what);
/// Where things shall go, behind their names.
ReadClause put_there(const EditText& text, Read<Ids> what);

}  // namespace roomgen
