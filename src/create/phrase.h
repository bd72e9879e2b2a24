#pragma once

#include <string>
#include <vector>

#include "kinds.h"
#include "roomgen/create/maker.h"
#include "words.h"

namespace roomgen::create {

/// Reads what an English sentence says about one object, and about others that it names beside it.
/// The first is the main one. Never fails on what it does not understand: it leaves it out. A noun
/// that is no kind is kept, with the nearest kind, if there is one, and `approximate` set.
std::vector<Description> read_phrase(const std::string& prompt, const Words& words,
                                     const ShapeKinds& kinds);

}  // namespace roomgen::create
