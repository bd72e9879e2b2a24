#pragma once

#include "roomgen/create/maker.h"

namespace roomgen::create {

/// What a model is shown of a request.

/// The description as JSON, behind a line that says what it is; empty without parts and sizes.
std::string description_text(const Description& description);
/// As many of the programs, nearest first, as a prompt may hold; empty if there are none.
std::string examples_text(const std::vector<shape::Program>& examples);
/// "bar stool, bed, …" or a sentence that says there are none.
std::string kinds_text(const std::vector<std::string>& kinds);
/// One line of JSON.
std::string program_text(const shape::Program& program);

/// The forms of answers, for models that can be held to one. What is optional in shape programs is
/// optional here, and the members of drawn solids and of operations are left to the reader: a
/// grammar of all of them would be larger than most answers.

const Json& verdict_schema();
const Json& decompose_schema();
const Json& program_schema();
const Json& mesh_schema();
const Json& scores_schema();

}  // namespace roomgen::create
