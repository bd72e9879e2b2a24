#pragma once

#include <string>
#include <vector>

#include "train/marked_edits.h"

namespace roomgen {

/// What the `member`-th model of the committee learns from: the first one from all, each other one from two thirds.
std::vector<MarkedEdit> lesson_of(const std::vector<MarkedEdit>& edits, std::size_t member);

/// Learns roles, deeds and places: the bytes that RoleModel reads. The same sentences give the same bytes.
std::string learn_roles(const std::vector<MarkedEdit>& edits);

}  // namespace roomgen
