#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/shape/program.h"

/// Shape programs with parameters (docs/shapes.md). A concrete program is a recipe without any.
namespace roomgen::shape {

inline constexpr std::size_t max_program_bytes = 1u << 20;
inline constexpr int max_use_depth = 8;

/// What an expression, a parameter or a let can be: a number or a word.
using Value = std::variant<double, std::string>;
using Values = std::map<std::string, Value, std::less<>>;

/// As people write it: 0.4, round.
std::string to_text(const Value& value);

struct Parameter {
  std::string name, about;
  Value value = 0.0;  ///< unless told otherwise
  double min = 0.0, max = 0.0;
  bool integer = false;
  bool color = false;                ///< any colour
  std::vector<std::string> choices;  ///< of a word
};

/// Finds a recipe by the name that `use` gives.
using RecipeSource = std::function<Result<Json>(const std::string& name)>;

/// JSON of at most max_program_bytes.
Result<Json> parse_recipe(std::string_view text, const std::string& source);
Result<Json> read_recipe(const std::filesystem::path& path);
/// Recipes of a folder: "leg" is leg.json in it.
RecipeSource recipes_in(const std::filesystem::path& folder);

/// `source` names the document in messages, here and below.
Result<std::vector<Parameter>> describe_parameters(const Json& recipe,
                                                   const std::string& source = "recipe");

/// A value of `text` for the parameter: a number, or a word.
Value parameter_value(const Parameter& parameter, const std::string& text);

/// The nearest values that the parameters allow: numbers moved into their range and made whole, a
/// word that is no choice replaced by the default; what no parameter is called is dropped.
Values clamped(const std::vector<Parameter>& parameters, const Values& values);

/// The concrete program for these values; parameters without one have their default. Equal
/// arguments give equal programs. A value out of range is an error that names the range.
///
/// What is used becomes a group of the component's name; its connections come along. Its seed
/// follows from the seed and that name.
Result<Program> instantiate(const Json& recipe, const Values& parameters = {},
                            std::uint64_t seed = 0, const RecipeSource& lookup = nullptr,
                            const std::string& source = "recipe");

}  // namespace roomgen::shape
