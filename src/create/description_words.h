#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/create/maker.h"

namespace roomgen::create {

/// Bounds of what a description holds, in files and in answers.
inline constexpr int max_count = 200;
inline constexpr std::size_t max_parts = 200;
inline constexpr std::size_t max_touches = 50;
inline constexpr std::size_t max_word = 100;      ///< bytes of a label, a material, a style
inline constexpr std::size_t max_prompt = 10000;  ///< bytes
inline constexpr double least_size = 0.001, greatest_size = 20.0;  ///< metres
inline constexpr double least_scale = 0.05, greatest_scale = 20.0;
inline constexpr double greatest_lean = 89.0;  ///< degrees, either way

/// "s-curve", as files and answers write it.
std::string_view name(Course course);
std::string_view name(Strength strength);
/// Whatever the case and the separators: "S curve", "s_curve".
std::optional<Course> course_named(std::string_view text);
std::optional<Strength> strength_named(std::string_view text);
std::optional<Place> place_named(std::string_view text);
std::vector<std::string> course_names();
std::vector<std::string> strength_names();

}  // namespace roomgen::create
