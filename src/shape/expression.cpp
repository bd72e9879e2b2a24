#include "expression.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "expression_parser.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen::shape {

namespace {

using detail::error_at;
using Node = Expression::Node;

// SplitMix64's finalizer (Steele et al. 2014): well mixed even for seeds and numbers that lie
// close.
double hash(std::uint64_t seed, double number) {
  std::uint64_t z = seed * 0x9e3779b97f4a7c15u + std::bit_cast<std::uint64_t>(number + 0.0);
  for (int round = 0; round < 2; ++round) {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
  }
  return static_cast<double>(z >> 11) * 0x1.0p-53;
}

double in_radians(double degrees) {
  return degrees * (3.14159265358979323846 / 180.0);
}

Result<double> applied(const Node& node, double a, double b) {
  const std::string& name = node.text;
  if (name == "+") return a + b;
  if (name == "-") return a - b;
  if (name == "*") return a * b;
  if (name == "<") return a < b ? 1.0 : 0.0;
  if (name == "<=") return a <= b ? 1.0 : 0.0;
  if (name == ">") return a > b ? 1.0 : 0.0;
  if (name == ">=") return a >= b ? 1.0 : 0.0;
  if (b == 0.0) return error_at(node.column, "division by zero");
  return a / b;
}

Result<double> called(const Node& node, const std::vector<double>& x, std::uint64_t seed) {
  const std::string& name = node.text;
  if (name == "min") return *std::min_element(x.begin(), x.end());
  if (name == "max") return *std::max_element(x.begin(), x.end());
  if (name == "abs") return std::abs(x[0]);
  if (name == "floor") return std::floor(x[0]);
  if (name == "ceil") return std::ceil(x[0]);
  if (name == "round") return std::round(x[0]);
  if (name == "sin") return std::sin(in_radians(x[0]));
  if (name == "cos") return std::cos(in_radians(x[0]));
  if (name == "tan") return std::tan(in_radians(x[0]));
  if (name == "pow") return std::pow(x[0], x[1]);
  if (name == "mix") return x[0] + (x[1] - x[0]) * x[2];
  if (name == "hash") return hash(seed, x[0]);
  if (name == "clamp") {
    if (x[1] > x[2]) return error_at(node.column, "clamp: the low bound is above the high one");
    return std::clamp(x[0], x[1], x[2]);
  }
  if (name == "mod") {
    if (x[1] == 0.0) return error_at(node.column, "division by zero in mod");
    return x[0] - x[1] * std::floor(x[0] / x[1]);
  }
  if (x[0] < 0.0) return error_at(node.column, "sqrt of a negative number");
  return std::sqrt(x[0]);
}

class Evaluation {
 public:
  Evaluation(const std::vector<Node>& nodes, const Scope& scope) : nodes_(nodes), scope_(scope) {}

  Result<Value> value(std::size_t index) const {
    const Node& node = nodes_[index];
    switch (node.kind) {
      case Node::Kind::number:
        return Value(node.number);
      case Node::Kind::word:
        return Value(node.text);
      case Node::Kind::name:
        return named(node);
      case Node::Kind::negate:
        return as_value(mapped(node, [](double x) { return -x; }));
      case Node::Kind::inverse:
        return as_value(mapped(node, [](double x) { return x == 0.0 ? 1.0 : 0.0; }));
      case Node::Kind::binary:
        return binary(node);
      case Node::Kind::call:
        return call(node);
    }
    return Value(0.0);
  }

  Result<double> number(std::size_t index) const {
    auto result = value(index);
    if (!result) return result.error();
    if (const auto* number = std::get_if<double>(&*result)) return *number;
    return error_at(nodes_[index].column,
                    "expected a number, not the word \"" + std::get<std::string>(*result) + "\"");
  }

 private:
  static Result<Value> as_value(const Result<double>& number) {
    if (!number) return number.error();
    return Value(*number);
  }

  static Result<Value> finite(const Node& node, const Result<double>& number) {
    if (number && !std::isfinite(*number))
      return error_at(node.column, "\"" + node.text + "\" gives no finite number");
    return as_value(number);
  }

  template <typename F>
  Result<double> mapped(const Node& node, F f) const {
    const auto x = number(node.arguments[0]);
    if (!x) return x.error();
    return f(*x);
  }

  Result<Value> named(const Node& node) const {
    if (const auto found = scope_.values.find(node.text); found != scope_.values.end())
      return found->second;
    if (scope_.words.count(node.text)) return Value(node.text);
    std::vector<std::string> known;
    for (const auto& [name, ignored] : scope_.values) known.push_back(name);
    known.insert(known.end(), scope_.words.begin(), scope_.words.end());
    const std::string close = closest_name(node.text, known);
    return error_at(node.column, "unknown name \"" + node.text + "\"" +
                                     (close.empty() ? "" : "; did you mean \"" + close + "\"?"));
  }

  Result<Value> binary(const Node& node) const {
    if (node.text == "==" || node.text == "!=") return equality(node);
    const auto left = number(node.arguments[0]);
    if (!left) return left.error();
    if (node.text == "and" && *left == 0.0) return Value(0.0);
    if (node.text == "or" && *left != 0.0) return Value(1.0);
    const auto right = number(node.arguments[1]);
    if (!right) return right.error();
    if (node.text == "and" || node.text == "or") return Value(*right != 0.0 ? 1.0 : 0.0);
    return finite(node, applied(node, *left, *right));
  }

  Result<Value> equality(const Node& node) const {
    const auto left = value(node.arguments[0]);
    if (!left) return left.error();
    const auto right = value(node.arguments[1]);
    if (!right) return right.error();
    if (left->index() != right->index())
      return error_at(node.column, "a number and a word (" + to_text(*left) + ", " +
                                       to_text(*right) + ") cannot be compared");
    return Value((*left == *right) == (node.text == "==") ? 1.0 : 0.0);
  }

  Result<Value> call(const Node& node) const {
    if (node.text == "if") {
      const auto condition = number(node.arguments[0]);
      if (!condition) return condition.error();
      return value(node.arguments[*condition != 0.0 ? 1 : 2]);
    }
    std::vector<double> arguments;
    for (const std::size_t argument : node.arguments) {
      const auto x = number(argument);
      if (!x) return x.error();
      arguments.push_back(*x);
    }
    return finite(node, called(node, arguments, scope_.seed));
  }

  const std::vector<Node>& nodes_;
  const Scope& scope_;
};

// Writes a formula, folding what depends on no free name.
class Binding {
 public:
  Binding(const std::vector<Node>& nodes, const Scope& scope,
          const std::set<std::string, std::less<>>& free)
      : nodes_(nodes), scope_(scope), free_(free), open_(nodes.size()) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      open_[i] = nodes[i].kind == Node::Kind::name && free.count(nodes[i].text);
      for (const std::size_t argument : nodes[i].arguments) open_[i] = open_[i] || open_[argument];
    }
  }

  std::string text(std::size_t index, int around = 0) {
    if (!open_[index]) return folded(index, around);
    const Node& node = nodes_[index];
    std::string result;
    switch (node.kind) {
      case Node::Kind::negate:
        result = "-" + text(node.arguments[0], 7);
        break;
      case Node::Kind::inverse:
        result = "not " + text(node.arguments[0], 3);
        break;
      case Node::Kind::binary: {
        const int binds = detail::precedence(node);
        result = text(node.arguments[0], binds + (binds == 4)) + " " + node.text + " " +
                 text(node.arguments[1], binds + 1);
        break;
      }
      case Node::Kind::call:
        result = call(node);
        break;
      default:
        result = node.text;
    }
    return detail::precedence(node) < around ? "(" + result + ")" : result;
  }

  const std::optional<Error>& error() const { return error_; }

 private:
  std::string call(const Node& node) {
    if (node.text == "hash")
      error_ = error_at(node.column,
                        "hash() must not depend on " + join({free_.begin(), free_.end()}, ", "));
    std::vector<std::string> arguments;
    for (const std::size_t argument : node.arguments) arguments.push_back(text(argument));
    return node.text + "(" + join(arguments, ", ") + ")";
  }

  std::string folded(std::size_t index, int around) {
    const auto value = Evaluation(nodes_, scope_).value(index);
    if (!value) {
      if (!error_) error_ = value.error();
      return "0";
    }
    if (const auto* word = std::get_if<std::string>(&*value)) return "'" + *word + "'";
    const double number = std::get<double>(*value);
    const std::string text = Json(roomgen::rounded(number, 9)).dump();
    return number < 0 && around > 6 ? "(" + text + ")" : text;
  }

  const std::vector<Node>& nodes_;
  const Scope& scope_;
  const std::set<std::string, std::less<>>& free_;
  std::vector<bool> open_;
  std::optional<Error> error_;
};

}  // namespace

std::string to_text(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return format_number(*number, 6);
  return std::get<std::string>(value);
}

Expression::Expression(std::vector<Node> nodes) : nodes_(std::move(nodes)) {}

Result<Expression> Expression::compile(std::string_view text, std::size_t length_limit) {
  if (text.size() > length_limit)
    return Error{Error::Kind::limit,
                 "a formula longer than " + std::to_string(length_limit) + " characters"};
  auto nodes = detail::parse_expression(text);
  if (!nodes) return nodes.error();
  return Expression(*std::move(nodes));
}

Result<Value> Expression::value(const Scope& scope) const {
  return Evaluation(nodes_, scope).value(nodes_.size() - 1);
}

Result<double> Expression::number(const Scope& scope) const {
  return Evaluation(nodes_, scope).number(nodes_.size() - 1);
}

bool Expression::mentions(std::string_view name) const {
  return std::any_of(nodes_.begin(), nodes_.end(), [name](const Node& node) {
    return node.kind == Node::Kind::name && node.text == name;
  });
}

Result<std::string> Expression::bound(const Scope& scope,
                                      const std::set<std::string, std::less<>>& free) const {
  Binding binding(nodes_, scope, free);
  std::string text = binding.text(nodes_.size() - 1);
  if (binding.error()) return *binding.error();
  return text;
}

}  // namespace roomgen::shape
