#pragma once

#include "kinds.h"
#include "words.h"

namespace roomgen::create {

/// Reads what an English sentence says about one object, and about others that it names beside it.
/// The first is the main one. Never fails on what it does not understand: it leaves it out. A noun
/// that is no kind is kept, with the nearest kind, if there is one, and `approximate` set.
std::vector<Description> read_phrase(const std::string& prompt, const Words& words,
                                     const ShapeKinds& kinds);

/// Longest description that is read, bytes.
inline constexpr std::size_t longest_phrase = 2000;

/// Is it a thing that stands indoors, and one that can be? `objects` is what was read of the prompt.
Verdict classify_phrase(const std::string& prompt, const std::vector<Description>& objects,
                        const Words& words);

/// The kind that a description means when its place or its parts say more than its noun does: "a coat
/// rack for the wall" is a wall coat rack, "a chest of six drawers" a chest of drawers. Null if there
/// is none.
const ShapeKind* closer_kind(const Description& description, const ShapeKinds& kinds);

/// A thing of no known kind, from its parts alone: what carries at the bottom, columns, boards or
/// piles on it, what rises above, what sits on the sides (data/create/parts.json says which part
/// goes where). What the parts need to hold together, such as a post for branches, is added. `size`
/// is about its box.
shape::Program compose(const Description& description, const Vec3& size);

/// Adds parts to a thing whose recipe knows none of their names. False if there is nothing that
/// could bear them.
bool attach(shape::Program& program, const std::vector<PartWish>& parts);

struct Refinement {
  shape::Program program;
  std::vector<std::string> notes;  ///< what was changed, or not understood
};

/// An earlier program changed as a sentence says: "make the back taller", "remove the arms", "paint
/// the legs black", "give it three legs".
Refinement refine(const shape::Program& earlier, const std::string& wish, const Words& words);

}  // namespace roomgen::create
