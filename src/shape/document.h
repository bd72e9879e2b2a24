#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/json_reader.h"
#include "numbers.h"
#include "roomgen/shape/program.h"

/// What a program and a recipe have in common beside their components.
namespace roomgen::shape::detail {

/// Format, version, nesting.
void check_head(const JsonReader& document, const Numbers& numbers);

std::vector<Surface> read_surfaces(const JsonReader& materials, const Numbers& numbers);
/// Name to name.
std::map<std::string, std::string> same_names(const std::vector<Surface>& surfaces);

/// Reports pairs that name nothing the document has; returns those of which both ends are still
/// there (`when` may have dropped one).
std::vector<std::pair<std::string, std::string>> read_connections(
    const JsonReader& document, const std::vector<Component>& components, const Numbers& numbers);

}  // namespace roomgen::shape::detail
