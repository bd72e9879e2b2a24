#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/vec.h"
#include "shape/expression.h"

namespace roomgen::book {

using shape::Expression;
using shape::Values;

/// A whole number by which a design is set: its people, its tables.
struct Parameter {
  std::string name;
  double value = 1.0, least = 1.0, most = 1.0;
  std::vector<std::string> counts;  ///< kinds of things whose number it is
};

/// The parameter that is set by the people of a wish.
inline constexpr const char* people_parameter = "people";

/// A whole room with parameters (docs/designs.md).
struct Design {
  std::string name;
  std::vector<std::string> rooms;  ///< kinds of rooms that it is a design of, in words
  std::vector<std::string> words;  ///< what else speaks for it
  std::vector<Parameter> parameters;
  std::array<Expression, 2> usual;  ///< width and depth, over the parameters
  Vec2 least = Vec2::Ones(), most = Vec2::Ones();
  std::vector<Json> palettes;
  Json programs;          ///< shape programs by name, which things refer to; an object
  Json body;              ///< the plan's form, with formulas, without the members above
  std::string source;     ///< its file
  bool is_plain = false;  ///< it holds hardly anything: for rooms that no design is of
};

/// Located errors for what is not of the form; formulas are compiled and tried with the defaults.
Result<Design> read_design(const Json& json, const std::string& source);
/// The same without trying the formulas, for designs that are known to be sound.
Result<Design> parse_design(const Json& json, const std::string& source);
Result<Design> read_design(const std::filesystem::path& path);

/// The room's usual size with these values of the parameters.
Vec2 usual_size(const Design& design, const Values& values);
Values default_values(const Design& design);

/// How a design is laid into a room: set, mirrored (its west becomes east), then turned
/// counter-clockwise by quarters.
struct Setting {
  Values values;
  Vec2 size = Vec2::Ones();  ///< of the room after the turn, metres
  double height = 2.7;
  bool is_mirrored = false;
  int turns = 0;
  Json palette;   ///< words by role
  Json openings;  ///< in the place of the design's, told in its frame; null: the design's
};

/// What a model would have answered that had this design in mind (design/plan_reply.h): formulas
/// are numbers, "stands" is {"location": [x, y], "yaw_deg": number, "wall": bool} in the room's
/// frame.
Result<Json> answer_of(const Design& design, const Setting& setting);

}  // namespace roomgen::book
