#include "floor_shapes.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "base/json_reader.h"
#include "base/resource.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen::brief {

namespace {

constexpr std::size_t max_corners = 64;
constexpr int max_sides = 64;

Range read_range(const JsonReader& json, double low, double high) {
  const auto v = json.numbers(2, low, high);
  if (v[0] > v[1]) json.report("must be [low, high]");
  return {v[0], v[1]};
}

Draws read_draws(const JsonReader& json) {
  Draws draws;
  if (!json.exists()) return draws;
  for (const auto& [name, range] : json.members()) draws[name] = read_range(range, 0.0, 10.0);
  return draws;
}

// A number or a formula.
std::optional<shape::Expression> read_formula(const JsonReader& json) {
  const std::string text = json.is_string() ? json.text(100) : format_number(json.number(-10, 10), 4);
  auto formula = shape::Expression::compile(text);
  if (formula) return *std::move(formula);
  json.report(formula.error().message);
  return std::nullopt;
}

std::vector<FormulaPoint> read_points(const JsonReader& json) {
  std::vector<FormulaPoint> points;
  for (const auto& element : json.elements_or_none(max_corners)) {
    const auto pair = element.elements(2);
    if (pair.size() != 2) {
      element.report("must be [x, y]");
      continue;
    }
    auto x = read_formula(pair[0]), y = read_formula(pair[1]);
    if (x && y) points.push_back({*std::move(x), *std::move(y)});
  }
  return points;
}

void read_names(const JsonReader& json, const std::string& meaning,
                std::map<std::string, std::string, std::less<>>& names) {
  for (const auto& element : json.elements_or_none(100)) names[element.text(100)] = meaning;
}

OutlineKind read_outline(const JsonReader& json) {
  json.allow_only({"about", "names", "draw", "corners", "sides", "without", "area"});
  OutlineKind kind;
  kind.draws = read_draws(json["draw"]);
  kind.corners = read_points(json["corners"]);
  kind.sides = static_cast<int>(json["sides"].integer_or(0, 0, max_sides));
  for (const auto& element : json["without"].elements_or_none(max_corners))
    kind.without.push_back(static_cast<int>(element.integer_or(0, 0, max_sides)));
  kind.area = json["area"].number_or(1.0, 0.5, 2.0);
  if (kind.corners.size() < 3 && kind.sides < 3) json.report("needs corners or sides");
  return kind;
}

FeatureKind read_feature(const JsonReader& json) {
  json.allow_only({"names", "least", "draw", "along", "glazed", "cut"});
  FeatureKind kind;
  kind.draws = read_draws(json["draw"]);
  kind.least = json["least"].number(0.5, 20.0);
  kind.along = read_points(json["along"]);
  for (const auto& element : json["glazed"].elements_or_none(max_corners))
    kind.glazed.push_back(static_cast<std::size_t>(element.integer_or(0, 0, max_corners)));
  for (const auto& element : json["cut"].elements_or_none(2))
    if (auto formula = read_formula(element)) kind.cut.push_back(*std::move(formula));
  if (kind.along.size() < 2 && kind.cut.size() != 2) json.report("needs \"along\" or \"cut\"");
  return kind;
}

}  // namespace

Result<FloorShapes> parse_floor_shapes(std::string_view text, const std::string& source) {
  auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  root.allow_only({"about", "outlines", "proportions", "features"});
  FloorShapes shapes;
  for (const auto& [name, entry] : root["outlines"].members()) {
    shapes.outlines.emplace(name, read_outline(entry));
    read_names(entry["names"], name, shapes.outline_names);
  }
  for (const auto& [name, entry] : root["features"].members()) {
    shapes.features.emplace(name, read_feature(entry));
    read_names(entry["names"], name, shapes.feature_names);
  }
  for (const auto& [word, range] : root["proportions"].members())
    shapes.proportions[word] = read_range(range, 1.0, 6.0);
  if (problems.first()) return *problems.first();
  return shapes;
}

const Result<FloorShapes>& built_in_floor_shapes() {
  static const auto shapes = parse_floor_shapes(
      resource("data/floor-shapes.json").value_or("{}"), "data/floor-shapes.json");
  return shapes;
}

shape::Scope drawn(const Draws& draws, Random& random) {
  shape::Scope scope;
  for (const auto& [name, range] : draws)
    scope.values[name] = random.uniform(range.low, range.high);
  return scope;
}

}  // namespace roomgen::brief
