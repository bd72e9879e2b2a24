#pragma once

#include <nlohmann/json.hpp>

#include "roomgen/base/json.h"

/// The forms of answers, for models that can be held to one. What is optional in shape programs is
/// optional here, and the members of drawn solids and of operations are left to the reader: a
/// grammar of all of them would be larger than most answers.
namespace roomgen::create {

const Json& verdict_schema();
const Json& decompose_schema();
const Json& program_schema();
const Json& mesh_schema();
const Json& scores_schema();

}  // namespace roomgen::create
