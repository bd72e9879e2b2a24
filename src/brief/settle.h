#pragma once

#include <cstddef>
#include <optional>

#include "brief.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::brief {

/// Ends the reading: numbers of uncounted things, small things for what stands on others, rugs
/// under what stands on them, "behind" turned into "in front of" where the one behind needs the
/// wall.
void settle(Brief& brief, const KindTable& table);

/// What a mention stands on: the first such of its demands, an index into Brief::mentions.
std::optional<std::size_t> support_of(const Mention& mention);

/// Whether a relation puts one thing beside the other, on whichever side.
bool is_beside(RelationKind kind);

/// Finds what stands on what, and makes things small, or has them hang, as their supports need it:
/// first what is said of a thing itself, then what follows from its neighbours and its sentence.
/// Before: demands as they were read. After: what stands on a thing has the mount `surface`, or its
/// demand to stand there has become another.
void settle_supports(Brief& brief, const KindTable& table);

/// What follows for the things that carry others, once settle_supports has found them: tops wide
/// enough, and the place on the floor that is said of what they carry.
void settle_carriers(Brief& brief, const KindTable& table);

/// How many there are of what is named in the plural without a number: one for each of the people,
/// seats for the tables, as many as what it is joined to ("eight desks and lamps"), else a few.
void settle_numbers(Brief& brief, const KindTable& table);

/// What stands on several things of a kind, named in the plural without a number: one on each.
void settle_numbers_on_carriers(Brief& brief);

}  // namespace roomgen::brief
