#pragma once

#include "discourse.h"

namespace roomgen::brief {

/// Of what people have or share in such a room ("for people" in data/rooms.json: a desk each, a table for four) as much as
/// the prompt's people need, with the seats that go with it, unless the prompt names such things itself.
void bring_for_people(const Lexicon& lexicon, Brief& brief);

}  // namespace roomgen::brief
