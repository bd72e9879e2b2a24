#include "expression_parser.h"

#include <charconv>
#include <map>

#include "roomgen/base/text.h"

namespace roomgen::shape::detail {

namespace {

const std::map<std::string, Arity, std::less<>>& functions() {
  static const std::map<std::string, Arity, std::less<>> table = {
      {"if", {3, 3}},   {"min", {1, 16}},  {"max", {1, 16}}, {"clamp", {3, 3}},
      {"abs", {1, 1}},  {"floor", {1, 1}}, {"ceil", {1, 1}}, {"round", {1, 1}},
      {"sqrt", {1, 1}}, {"sin", {1, 1}},   {"cos", {1, 1}},  {"tan", {1, 1}},
      {"pow", {2, 2}},  {"mod", {2, 2}},   {"mix", {3, 3}},  {"hash", {1, 1}}};
  return table;
}

std::vector<std::string> function_names() {
  std::vector<std::string> names;
  for (const auto& [name, ignored] : functions()) names.push_back(name);
  return names;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

// Recursive descent, one function for all binary operators by their precedence. The first problem
// ends the parse: everything returns at once when `error_` is set.
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Result<std::vector<Node>> parse() {
    binary(1);
    skip_space();
    if (!error_ && at_ < text_.size()) fail("unexpected \"" + token() + "\"");
    if (error_) return *error_;
    return std::move(nodes_);
  }

 private:
  using Index = std::size_t;

  void fail(const std::string& what) {
    if (!error_) error_ = error_at(at_ + 1, what);
  }

  void skip_space() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n'))
      ++at_;
  }

  // The next token as text: a word, an operator of one or two characters, empty at the end.
  std::string token() {
    skip_space();
    if (at_ >= text_.size()) return "";
    std::size_t end = at_;
    while (end < text_.size() && (is_letter(text_[end]) || (end > at_ && is_digit(text_[end]))))
      ++end;
    if (end > at_) return std::string(text_.substr(at_, end - at_));
    for (const std::string_view pair : {"<=", ">=", "==", "!="})
      if (text_.substr(at_, 2) == pair) return std::string(pair);
    return std::string(1, text_[at_]);
  }

  bool take(std::string_view wanted) {
    if (token() != wanted) return false;
    at_ += wanted.size();
    return true;
  }

  Index add(Node node) {
    nodes_.push_back(std::move(node));
    return nodes_.size() - 1;
  }

  static int level(std::string_view token) {
    if (token == "or") return 1;
    if (token == "and") return 2;
    for (const std::string_view one : {"<", "<=", ">", ">=", "==", "!="})
      if (token == one) return 4;
    if (token == "+" || token == "-") return 5;
    if (token == "*" || token == "/") return 6;
    return 0;
  }

  Index binary(int lowest) {
    Index left = operand(lowest);
    bool compared = false;
    while (!error_) {
      const std::string name = token();
      const int binds = level(name);
      if (binds == 0 || binds < lowest) break;
      if (binds == 4 && compared) {
        fail("comparisons do not chain; join two with \"and\"");
        break;
      }
      compared = binds == 4;
      const std::size_t column = at_ + 1;
      at_ += name.size();
      const Index right = binary(binds + 1);
      left = add({Node::Kind::binary, 0.0, name, column, {left, right}});
    }
    return left;
  }

  Index operand(int lowest) {
    if (++depth_ > Expression::max_depth) {
      fail("nested more than " + std::to_string(Expression::max_depth) + " deep");
      return 0;
    }
    const Index result = error_ ? 0 : prefixed(lowest);
    --depth_;
    return result;
  }

  Index prefixed(int lowest) {
    const std::string next = token();
    const std::size_t column = at_ + 1;
    if (next == "not" && lowest <= 3) {
      take("not");
      return add({Node::Kind::inverse, 0.0, next, column, {binary(3)}});
    }
    if (next == "-" || next == "+") {
      take(next);
      const Index inner = operand(7);
      return next == "+" ? inner : add({Node::Kind::negate, 0.0, next, column, {inner}});
    }
    return primary();
  }

  Index primary() {
    const std::string next = token();
    const std::size_t column = at_ + 1;
    if (next.empty()) {
      fail("ends where a value is expected");
      return 0;
    }
    if (take("(")) {
      const Index inner = binary(1);
      expect(")");
      return inner;
    }
    if (next == "'") return quoted();
    if (is_digit(next[0]) || next[0] == '.') return literal();
    if (!is_letter(next[0]) || level(next) || next == "not") {
      fail("expected a value, not \"" + next + "\"");
      return 0;
    }
    at_ += next.size();
    if (token() == "(") return call(next, column);
    if (next == "pi") return add({Node::Kind::number, 3.14159265358979323846, "", column, {}});
    return add({Node::Kind::name, 0.0, next, column, {}});
  }

  Index literal() {
    double value = 0.0;
    const char* const first = text_.data() + at_;
    const auto [end, code] = std::from_chars(first, text_.data() + text_.size(), value);
    const std::size_t column = at_ + 1;
    if (code != std::errc()) {
      fail("no number");
      return 0;
    }
    at_ += static_cast<std::size_t>(end - first);
    return add({Node::Kind::number, value, "", column, {}});
  }

  Index quoted() {
    const std::size_t column = at_ + 1;
    const auto end = text_.find('\'', at_ + 1);
    if (end == std::string_view::npos) {
      fail("a word in quotes without an end");
      return 0;
    }
    std::string word(text_.substr(at_ + 1, end - at_ - 1));
    at_ = end + 1;
    return add({Node::Kind::word, 0.0, std::move(word), column, {}});
  }

  Index call(const std::string& name, std::size_t column) {
    const auto wanted = arity(name);
    if (!wanted) {
      error_ = error_at(column, "no function \"" + name + "\"" + suggestion(name));
      return 0;
    }
    take("(");
    Node node{Node::Kind::call, 0.0, name, column, {}};
    do {
      node.arguments.push_back(binary(1));
    } while (!error_ && take(",") && node.arguments.size() < 17);
    expect(")");
    const std::size_t count = node.arguments.size();
    if (!error_ && (count < wanted->least || count > wanted->most))
      error_ = error_at(column, name + " takes " + std::to_string(wanted->least) +
                                    (wanted->most > wanted->least ? " or more" : "") +
                                    " arguments, not " + std::to_string(count));
    return add(std::move(node));
  }

  static std::string suggestion(const std::string& name) {
    const std::string close = closest_name(name, function_names());
    return close.empty() ? "; there are " + join(function_names(), ", ")
                         : "; did you mean \"" + close + "\"?";
  }

  void expect(std::string_view wanted) {
    if (!error_ && !take(wanted)) {
      const std::string found = token();
      fail("expected \"" + std::string(wanted) + "\"" +
           (found.empty() ? "" : ", not \"" + found + "\""));
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::vector<Node> nodes_;
  std::optional<Error> error_;
};

}  // namespace

Error error_at(std::size_t column, const std::string& what) {
  return {Error::Kind::invalid_input, "column " + std::to_string(column) + ": " + what};
}

int precedence(const Node& node) {
  switch (node.kind) {
    case Node::Kind::inverse:
      return 3;
    case Node::Kind::negate:
      return 7;
    case Node::Kind::number:
      return node.number < 0 ? 7 : 8;
    case Node::Kind::binary:
      if (node.text == "or") return 1;
      if (node.text == "and") return 2;
      if (node.text == "+" || node.text == "-") return 5;
      return node.text == "*" || node.text == "/" ? 6 : 4;
    default:
      return 8;
  }
}

std::optional<Arity> arity(std::string_view function) {
  const auto found = functions().find(function);
  if (found == functions().end()) return std::nullopt;
  return found->second;
}

Result<std::vector<Node>> parse_expression(std::string_view text) {
  return Parser(text).parse();
}

}  // namespace roomgen::shape::detail
