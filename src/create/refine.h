#pragma once

#include <string>
#include <vector>

#include "roomgen/shape/program.h"
#include "words.h"

namespace roomgen::create {

struct Refinement {
  shape::Program program;
  std::vector<std::string> notes;  ///< what was changed, or not understood
};

/// An earlier program changed as a sentence says: "make the back taller", "remove the arms", "paint
/// the legs black", "give it three legs".
Refinement refine(const shape::Program& earlier, const std::string& wish, const Words& words);

}  // namespace roomgen::create
