#pragma once

#include <cstdint>
#include <string>

#include "chat/interview.h"
#include "roomgen/create/maker.h"
#include "roomgen/shape/program.h"

namespace roomgen::create {

/// The concrete program of an answer, which may be a recipe. It was tried: it makes bodies of a
/// size that furniture has. An error is what to tell the model, with the JSON pointer where there
/// is one; the complaint says where the program is not what was described.
Result<Reading<shape::Program>> read_program_reply(const std::string& text,
                                                   const Description& wanted, std::uint64_t seed);

}  // namespace roomgen::create
