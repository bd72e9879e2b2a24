#pragma once

#include <string>

#include "roomgen/library/library.h"

namespace roomgen::create {

/// What is known of a thing by its kind alone: its front, whether it is round, and, if `carries`,
/// that things stand on its top.
void describe_by_kind(AssetInfo& info, const std::string& kind, bool carries);

}  // namespace roomgen::create
