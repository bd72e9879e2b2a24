#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace roomgen {

/// A file of the repository's data/ or prompts/ folder, or a schema of docs/, compiled into the library, by its path there
/// ("data/rooms.json"). The view lives as long as the program.
std::optional<std::string_view> resource(std::string_view path);

/// The paths of all resources that start with `prefix`, sorted.
std::vector<std::string_view> resources(std::string_view prefix);

}  // namespace roomgen
