#pragma once

#include <optional>
#include <string>

#include "edit_roles.h"

namespace roomgen {

// What the parts of an order say, found anywhere among their words.

/// The words that measure a length, or say one vaguely: "20 cm" of "by a good 20 cm or so".
std::optional<RoleStretch> length_within(const EditText& text, const RoleStretch& part);
/// Degrees, counter-clockwise from above: "a hundred and thirty degrees to the right", "an eighth of a turn".
std::optional<double> turn_within(const EditText& text, const SpokenOrder& order);
/// "90 x 90", "80 by 60": width and depth, or width and height of what hangs; and more as written.
std::optional<std::vector<double>> sides_within(const EditText& text, const RoleStretch& part);
/// A look as the library is asked for it: of "in a warm walnut" "warm walnut"; of "slim brass ones" "slim brass".
std::string plain_look_of(const EditText& text, const RoleStretch& part);

}  // namespace roomgen
