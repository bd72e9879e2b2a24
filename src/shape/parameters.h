#pragma once

#include <vector>

#include "base/json_reader.h"
#include "numbers.h"
#include "roomgen/shape/program.h"

namespace roomgen::shape::detail {

std::vector<Parameter> read_parameters(const JsonReader& parameters);

/// Is its value a word: one of its choices, a colour, any text?
bool wants_word(const Parameter& parameter);

/// What is wrong with a value; empty if nothing is.
std::string objection(const Parameter& parameter, const Value& value);

/// Parameters with their values, the choices as words, then the lets.
Scope make_scope(const std::vector<Parameter>& parameters, const Values& values,
                 std::uint64_t seed);
void add_lets(const JsonReader& lets, const Numbers& numbers);

}  // namespace roomgen::shape::detail
