#pragma once

#include <cstddef>

namespace roomgen::program_limits {

/// What a program may hold. Far above what anybody writes, and low enough that whoever walks a program
/// neither overflows its stack nor takes long.
inline constexpr int set_depth = 12;
inline constexpr int term_depth = 24;
inline constexpr std::size_t nodes = 20000;   ///< sets and terms together
inline constexpr std::size_t names = 1000;    ///< in a list of sets, constraints, parameters, ...
inline constexpr std::size_t operands = 1000;
inline constexpr std::size_t name_bytes = 100;
inline constexpr std::size_t tags = 20;
inline constexpr std::size_t set_relations = 8;
inline constexpr std::size_t objects = 1000;  ///< that a program may demand
inline constexpr double number = 1e9;

}  // namespace roomgen::program_limits
