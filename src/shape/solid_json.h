#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/json_reader.h"
#include "color.h"
#include "letters.h"
#include "numbers.h"
#include "roomgen/shape/program.h"

namespace roomgen::shape::detail {

/// The keys of solids, without "group".
std::vector<std::string> solid_keys();
/// Precondition: `key` is one of solid_keys(); `json` is what stands under it.
Solid read_solid(std::string_view key, const JsonReader& json, const Numbers& numbers);
/// The key and what stands under it. Precondition: no Group.
std::pair<std::string, Json> write_solid(const Solid& solid);

/// "#rrggbb" or a name; reports anything else.
Rgb read_color(const JsonReader& json, const Numbers& numbers);
/// left, center or right; center unless told.
Align read_align(const JsonReader& json, const Numbers& numbers);
/// Words to be lettered, at least one of them.
std::string read_words(const JsonReader& json, const Numbers& numbers);

Operation read_operation(const JsonReader& json, const Numbers& numbers);
Json write_operation(const Operation& operation);

Surface read_surface(const std::string& name, const JsonReader& json, const Numbers& numbers);
Json write_surface(const Surface& surface);

/// Numbers as files have them.
double metres(double value);
double file_degrees(double angle);
Json to_json(const Vec2& v);
Json to_json(const Vec3& v);

}  // namespace roomgen::shape::detail
