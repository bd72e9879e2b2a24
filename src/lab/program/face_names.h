#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/lab/program.h"

namespace roomgen::lab {

std::string_view name(Face face);
std::optional<Face> parse_face(std::string_view text);
/// The faces that a word names: one, or several ("side": all upright ones but the back; "leftright").
/// None for an unknown word.
std::vector<Face> faces_named(std::string_view word);
/// All words for faces, those for several too.
std::vector<std::string> face_words();
bool is_of_room(Face face);

/// A direction of `access` from a name ("front", "sides") or an axis as the source's programs say it
/// ("+x", "+-y", where the front looks along +x and left is +y). Empty for an unknown word.
std::string direction_named(std::string_view word);
std::vector<std::string> direction_words();

}  // namespace roomgen::lab
