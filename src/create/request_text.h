#pragma once

#include <string>
#include <vector>

#include "roomgen/create/maker.h"
#include "roomgen/shape/program.h"

/// What a model is shown of a request.
namespace roomgen::create {

/// The description as JSON, behind a line that says what it is; empty without parts and sizes.
std::string description_text(const Description& description);
/// As many of the programs, nearest first, as a prompt may hold; empty if there are none.
std::string examples_text(const std::vector<shape::Program>& examples);
/// "bar stool, bed, …" or a sentence that says there are none.
std::string kinds_text(const std::vector<std::string>& kinds);
/// One line of JSON.
std::string program_text(const shape::Program& program);

}  // namespace roomgen::create
