#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "expression.h"

namespace roomgen::shape::detail {

using Node = Expression::Node;

Error error_at(std::size_t column, const std::string& what);

/// How tightly an operator binds: or 1, and 2, not 3, comparison 4, sum 5, product 6, sign 7.
int precedence(const Node& node);

/// Number of arguments of a function, at least and at most; none if there is no such function.
struct Arity {
  std::size_t least = 1, most = 1;
};
std::optional<Arity> arity(std::string_view function);

/// The nodes of a formula, arguments first, the root last.
Result<std::vector<Node>> parse_expression(std::string_view text);

}  // namespace roomgen::shape::detail
