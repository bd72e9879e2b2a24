#pragma once

#include "roomgen/shape/evaluate.h"

/// Connected groups of a shape's bodies by points scattered over the surfaces, without the
/// distances that the validator uses: bodies hang together when points of theirs are within about 5
/// mm, or one is in the other.
int pieces_by_sampling(const roomgen::shape::Shape& shape);
