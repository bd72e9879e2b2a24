#include "shape/expression.h"

#include <cmath>
#include <functional>

#include "base/random.h"
#include "catch.h"
#include "support/contains.h"

using namespace roomgen;
using namespace roomgen::shape;

namespace {

Scope some_scope() {
  Scope scope;
  scope.values = {{"a", 2.0}, {"b", -0.5}, {"seat", std::string("round")}, {"width", 0.4}};
  scope.words = {"round", "square"};
  scope.seed = 7;
  return scope;
}

double number(const std::string& text) {
  const auto expression = Expression::compile(text);
  INFO(text << ": " << (expression ? "" : expression.error().message));
  REQUIRE(expression);
  const auto value = expression->number(some_scope());
  INFO(text << ": " << (value ? "" : value.error().message));
  REQUIRE(value);
  return *value;
}

std::string problem(const std::string& text) {
  const auto expression = Expression::compile(text);
  if (!expression) return expression.error().message;
  const auto value = expression->value(some_scope());
  INFO(text);
  REQUIRE_FALSE(value);
  return value.error().message;
}

// A random formula and, computed beside it, what it is. All numbers are positive and at least 0.1,
// so that every operation is defined.
struct Formula {
  std::string text;
  double value = 0.0;
};

Formula random_formula(Random& random, int depth) {
  if (depth == 0 || random.chance(0.2)) {
    if (random.chance(0.3)) return {"a", 2.0};
    const int tenths = random.integer(1, 90);
    return {std::to_string(tenths / 10) + "." + std::to_string(tenths % 10), tenths / 10.0};
  }
  const Formula x = random_formula(random, depth - 1), y = random_formula(random, depth - 1);
  switch (random.integer(0, 9)) {
    case 0:
      return {"(" + x.text + " + " + y.text + ")", x.value + y.value};
    case 1:
      return {"(" + x.text + ") * (" + y.text + ")", x.value * y.value};
    case 2:
      return {"(" + x.text + ") / (" + y.text + ")", x.value / y.value};
    case 3:
      return {"abs(" + x.text + " - (" + y.text + ")) + 0.1", std::abs(x.value - y.value) + 0.1};
    case 4:
      return {"min(" + x.text + ", " + y.text + ")", std::min(x.value, y.value)};
    case 5:
      return {"if(" + x.text + " < (" + y.text + "), 1, 2)", x.value < y.value ? 1.0 : 2.0};
    case 6:
      return {"sqrt(" + x.text + ")", std::sqrt(x.value)};
    case 7:
      return {"ceil(" + x.text + ")", std::ceil(x.value)};
    case 8:
      return {"mix(" + x.text + ", " + y.text + ", 0.5)", (x.value + y.value) / 2};
    default:
      return {"(0.1 - -(" + x.text + "))", 0.1 + x.value};
  }
}

}  // namespace

TEST_CASE("Formulas follow the usual precedence") {
  CHECK(number("1 + 2 * 3") == 7.0);
  CHECK(number("(1 + 2) * 3") == 9.0);
  CHECK(number("8 - 2 - 1") == 5.0);
  CHECK(number("8 / 2 / 2") == 2.0);
  CHECK(number("-a * 3 + 1") == -5.0);
  CHECK(number("2 - -3") == 5.0);
  CHECK(number("not 0 and 1 or 0") == 1.0);
  CHECK(number("not a == 2") == 0.0);
  CHECK(number("1 + 1 < 3 and 2 >= a") == 1.0);
  CHECK(number(".5 + 1e-1") == Approx(0.6));
}

TEST_CASE("Functions give what they say") {
  CHECK(number("max(1, b, a)") == 2.0);
  CHECK(number("clamp(5, 0, 1)") == 1.0);
  CHECK(number("floor(b) + ceil(b) + round(2.5)") == 2.0);
  CHECK(number("sin(30) + cos(60)") == Approx(1.0));
  CHECK(number("tan(45) * pow(2, 3)") == Approx(8.0));
  CHECK(number("mod(-1, 3)") == 2.0);
  CHECK(number("mod(7, 3)") == 1.0);
  CHECK(number("mix(1, 3, 0.25)") == 1.5);
  CHECK(number("cos(pi)") == Approx(std::cos(3.14159265358979 * 3.14159265358979 / 180)));
}

TEST_CASE("Words compare as words") {
  CHECK(number("seat == round") == 1.0);
  CHECK(number("seat != square") == 1.0);
  CHECK(number("seat == 'round'") == 1.0);
  CHECK(number("if(seat == square, 1, 2)") == 2.0);
  CHECK(number("round(1.4)") == 1.0);  // the function, not the word
  CHECK(contains_text(problem("seat == 1"), "cannot be compared"));
  CHECK(contains_text(problem("seat + 1"), "column 1: expected a number, not the word \"round\""));
  CHECK(contains_text(problem("seat == roud"), "did you mean \"round\"?"));
}

TEST_CASE("Chance depends on the seed and its argument alone") {
  auto scope = some_scope();
  const auto hash = Expression::compile("hash(a)");
  REQUIRE(hash);
  const double first = *hash->number(scope);
  CHECK(*hash->number(scope) == first);
  CHECK((first >= 0.0 && first < 1.0));
  scope.seed = 8;
  CHECK(*hash->number(scope) != first);
  double sum = 0;
  for (int k = 0; k < 1000; ++k) {
    scope.values["a"] = static_cast<double>(k);
    sum += *hash->number(scope);
  }
  CHECK(sum == Approx(500).margin(40));
}

TEST_CASE("What is not needed is not evaluated") {
  CHECK(number("if(a > 0, 1, 1 / 0)") == 1.0);
  CHECK(number("0 and 1 / 0") == 0.0);
  CHECK(number("1 or 1 / 0") == 1.0);
}

TEST_CASE("Errors name the column and what is wrong") {
  CHECK(problem("1 / (a - 2)") == "column 3: division by zero");
  CHECK(problem("mod(1, 0)") == "column 1: division by zero in mod");
  CHECK(contains_text(problem("sqrt(b)"), "sqrt of a negative number"));
  CHECK(contains_text(problem("pow(-1, 0.5)"), "no finite number"));
  CHECK(contains_text(problem("pow(10, 400)"), "no finite number"));
  CHECK(contains_text(problem("1 + widht"),
                      "column 5: unknown name \"widht\"; did you mean \"width\"?"));
  CHECK(contains_text(problem("maxx(1)"), "did you mean \"max\"?"));
  CHECK(contains_text(problem("min()"), "column 5"));
  CHECK(contains_text(problem("clamp(1, 2)"), "clamp takes 3 arguments, not 2"));
  CHECK(contains_text(problem("1 < 2 < 3"), "do not chain"));
  CHECK(contains_text(problem("1 +"), "ends where a value is expected"));
  CHECK(contains_text(problem("(1"), "expected \")\""));
  CHECK(contains_text(problem("1 2"), "unexpected \"2\""));
  CHECK(contains_text(problem("1 + 'x"), "without an end"));
  CHECK(contains_text(problem("a = 2"), "column 3"));
  CHECK(contains_text(problem("system('ls')"), "no function \"system\""));
  CHECK(contains_text(problem("1e999"), "no number"));
  CHECK(contains_text(problem("nan"), "unknown name"));
  CHECK_FALSE(problem("").empty());
  CHECK_FALSE(problem(std::string("1\0+ 2", 6)).empty());
}

TEST_CASE("Hostile formulas end at once") {
  CHECK(contains_text(problem(std::string(501, '1')), "longer than 500"));
  for (const char* open : {"(", "-", "not ", "min(", "if(1,"}) {
    std::string text;
    while (text.size() < 490) text += open;
    CHECK(contains_text(problem(text), "nested more than 64"));
  }
  std::string sum = "1";
  while (sum.size() < 490) sum += "+1";
  CHECK(number(sum) == (sum.size() + 1) / 2);
  Random random(5);
  const std::string letters = "ab01.+-*/()<>=!,' &#\"\\notif";
  for (int k = 0; k < 20000; ++k) {
    std::string text;
    for (int length = random.integer(0, 30); length > 0; --length)
      text += letters[static_cast<std::size_t>(
          random.integer(0, static_cast<int>(letters.size()) - 1))];
    if (const auto compiled = Expression::compile(text)) (void)compiled->value(some_scope());
  }
}

TEST_CASE("Random formulas give what an independent evaluation gives") {
  Random random(11);
  int compared = 0;
  for (int k = 0; k < 5000; ++k) {
    const Formula formula = random_formula(random, random.integer(0, 5));
    if (formula.text.size() > Expression::max_length) continue;
    ++compared;
    INFO(formula.text);
    CHECK(number(formula.text) == Approx(formula.value).epsilon(1e-12));
  }
  CHECK(compared > 3000);
}

TEST_CASE("A bound formula has numbers in place of names and means the same") {
  auto scope = some_scope();
  Random random(3);
  for (const char* text : {"a * u + b * v", "(a + u) * (b - v)", "u - (v - a)",
                           "-(u + a) / (1 + v * v)", "if(u < b, a, a * v)", "not (u < 0 or v > b)",
                           "pow(abs(u), a) + hash(a)", "a - b * u", "u / (v + 3) / a"}) {
    const auto formula = Expression::compile(text);
    REQUIRE(formula);
    const auto bound = formula->bound(scope, {"u", "v"});
    REQUIRE(bound);
    INFO(text << " became " << *bound);
    const auto again = Expression::compile(*bound);
    REQUIRE(again);
    CHECK_FALSE(again->mentions("a"));
    Scope inner = scope, outer;
    for (int k = 0; k < 20; ++k) {
      inner.values["u"] = outer.values["u"] = random.uniform(-1, 1);
      inner.values["v"] = outer.values["v"] = random.uniform(-1, 1);
      CHECK(*again->number(outer) == Approx(*formula->number(inner)).margin(1e-8));
    }
    CHECK(*again->bound(Scope{}, {"u", "v"}) == *bound);
  }
  CHECK_FALSE(Expression::compile("hash(u)")->bound(scope, {"u"}));
  CHECK_FALSE(Expression::compile("c * u")->bound(scope, {"u"}));
}
