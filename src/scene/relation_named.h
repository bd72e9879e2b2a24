#pragma once

#include <optional>
#include <string_view>

#include "roomgen/scene/relation.h"

namespace roomgen {

/// The relation that files spell so, in lower case with single spaces; nothing if none is.
std::optional<RelationKind> relation_named(std::string_view text);

}  // namespace roomgen
