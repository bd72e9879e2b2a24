#pragma once

#include <string_view>

namespace roomgen {

/// What stands before the name of a mount in Requirement::attribute: "mount wall".
inline constexpr std::string_view mount_attribute = "mount ";

/// The attribute of a requirement of a room where `amount` people shall sit.
inline constexpr std::string_view seats_for_people = "seats for people";

}  // namespace roomgen
