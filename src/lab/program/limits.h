#pragma once

#include <cstddef>

namespace roomgen::lab::program_limits {

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
inline constexpr std::size_t variables = 8;   ///< in force at one place
inline constexpr double permitted =
    4.0;  ///< things beyond the least, where no bound says how many at most
inline constexpr double members = 320.0;      ///< of a set, in the fullest room
inline constexpr double work = 1e6;  ///< steps of one look at the fullest room (check_work.h)
inline constexpr double number = 1e9;

}  // namespace roomgen::lab::program_limits
