#pragma once

#include <string_view>

namespace roomgen {

/// What stands before the name of a mount in Requirement::attribute: "mount wall".
inline constexpr std::string_view mount_attribute = "mount ";

}  // namespace roomgen
