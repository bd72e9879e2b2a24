#pragma once

#include <cstddef>
#include <optional>

#include "brief.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::brief {

/// What a mention stands on: the first such of its demands, an index into Brief::mentions.
std::optional<std::size_t> support_of(const Mention& mention);

/// Whether a relation puts one thing beside the other, on whichever side.
bool is_beside(RelationKind kind);

/// Finds what stands on what, and makes things small, or has them hang, as their supports need it:
/// first what is said of a thing itself, then what follows from its neighbours and its sentence.
/// Before: demands as they were read. After: what stands on a thing has the mount `surface`, or its
/// demand to stand there has become another.
void settle_supports(Brief& brief, const KindTable& table);

}  // namespace roomgen::brief
