#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/shape/program.h"

namespace roomgen::shape {

/// What names mean.
struct Scope {
  Values values;
  /// Words that may stand for themselves (`seat == round`): the choices of the parameters.
  std::set<std::string, std::less<>> words;
  std::uint64_t seed = 0;  ///< of hash(n)
};

/// A formula of a recipe, compiled once. Numbers and words ('two words' in single quotes); or, and,
/// not, comparisons, + - * /, brackets; pi; if(c, a, b), min, max, clamp(x, low, high), abs, floor,
/// ceil, round, sqrt, pow, mod (with the sign of the divisor), mix(a, b, t), sin, cos, tan (of
/// degrees), hash(n): a random number in [0, 1) that depends on the seed and n alone. True is 1,
/// false 0; and, or and if evaluate only what they need. There are no loops, so the length bounds
/// the work. A result that is not finite is an error.
///
/// Errors name the column, from 1.
class Expression {
 public:
  static constexpr std::size_t max_length = 500;
  /// A bound formula is longer than what was written: numbers stand in place of names.
  static constexpr std::size_t max_bound_length = 8000;
  static constexpr int max_depth = 64;

  static Result<Expression> compile(std::string_view text, std::size_t length_limit = max_length);

  Result<Value> value(const Scope& scope) const;
  Result<double> number(const Scope& scope) const;

  /// Does the name occur?
  bool mentions(std::string_view name) const;
  /// How many numbers, names, operators and calls it has.
  std::size_t size() const { return nodes_.size(); }

  /// The same formula as text, with the scope's values in place of names; the names of `free` are
  /// left as they are, any other is an error. hash() of a free name is refused: the seed does not
  /// travel with the text.
  Result<std::string> bound(const Scope& scope,
                            const std::set<std::string, std::less<>>& free) const;

  struct Node {
    enum class Kind { number, word, name, negate, inverse, binary, call };
    Kind kind = Kind::number;
    double number = 0.0;
    std::string text;  ///< of a word, name, operator or function
    std::size_t column = 1;
    std::vector<std::size_t> arguments;  ///< indices of nodes
  };

 private:
  explicit Expression(std::vector<Node> nodes);
  std::vector<Node> nodes_;  ///< arguments before their operator; the last is the root
};

}  // namespace roomgen::shape
