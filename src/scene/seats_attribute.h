#pragma once

#include <string_view>

namespace roomgen {

/// The attribute of a requirement of a room where `amount` people shall sit.
inline constexpr std::string_view seats_for_people = "seats for people";

}  // namespace roomgen
