#include "design.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "roomgen/base/file.h"

namespace roomgen::book {

namespace {

constexpr std::size_t most_words = 80, most_parameters = 12, most_palettes = 12;
constexpr std::size_t longest_text = 4000;
constexpr double most_people = 400;

std::string formula_text(const JsonReader& json) {
  if (json.is_string()) return json.text(Expression::max_length);
  return json_line(Json(json.number(-1000, 1000)));
}

std::vector<std::string> texts_of(const JsonReader& json) {
  std::vector<std::string> texts;
  for (const auto& one : json.elements_or_none(most_words)) texts.push_back(one.text(100));
  return texts;
}

Parameter read_parameter(const std::string& name, const JsonReader& json) {
  json.allow_only({"default", "least", "most", "counts"});
  Parameter parameter{name, json["default"].number(0, most_people), 0, 0, texts_of(json["counts"])};
  parameter.least = json["least"].number_or(parameter.value, 0, most_people);
  parameter.most = json["most"].number_or(parameter.value, 0, most_people);
  if (parameter.least > parameter.value || parameter.most < parameter.value)
    json.report("the default must lie between least and most");
  return parameter;
}

Vec2 read_bound(const JsonReader& json, const Vec2& fallback) {
  if (!json.exists()) return fallback;
  const auto sides = json.numbers(2, 0.5, 60);
  return sides.size() == 2 ? Vec2(sides[0], sides[1]) : fallback;
}

void read_size(const JsonReader& json, Design& design) {
  json.allow_only({"usual", "least", "most"});
  const auto usual = json["usual"].elements(2);
  if (usual.size() != 2) return json["usual"].report("two numbers or formulas are expected");
  for (std::size_t i = 0; i < 2; ++i) {
    auto formula = Expression::compile(formula_text(usual[i]));
    if (!formula) return usual[i].report(formula.error().message);
    design.usual[i] = *std::move(formula);
    if (const auto side = design.usual[i].number({default_values(design), {}, 0}); !side)
      return usual[i].report(side.error().message);
  }
  const Vec2 size = usual_size(design, default_values(design));
  design.least = read_bound(json["least"], 0.8 * size);
  design.most = read_bound(json["most"], 1.5 * size);
}

const char* const own_members[] = {"format",     "version", "name",     "for",    "words",
                                   "parameters", "size_m",  "programs", "remarks"};

}  // namespace

Values default_values(const Design& design) {
  Values values;
  for (const auto& parameter : design.parameters) values[parameter.name] = parameter.value;
  return values;
}

Vec2 usual_size(const Design& design, const Values& values) {
  Vec2 size(3.0, 3.0);
  for (std::size_t i = 0; i < 2; ++i)
    if (const auto side = design.usual[i].number({values, {}, 0}))
      size[static_cast<Eigen::Index>(i)] = std::clamp(*side, 0.8, 50.0);
  return size;
}

Result<Design> parse_design(const Json& json, const std::string& source) {
  JsonReader::Problems problems(source);
  const JsonReader root(json, problems);
  root.allow_only({"format", "version", "name", "for", "words", "concept", "parameters", "size_m",
                   "room", "openings", "groups", "objects", "excluded", "remarks", "programs"});
  if (root["format"].text_or("roomgen-design") != "roomgen-design")
    root["format"].report("expected \"roomgen-design\"");
  auto anything = Expression::compile("1");
  Design design{root["name"].text(200),
                texts_of(root["for"]),
                texts_of(root["words"]),
                {},
                {*anything, *anything},
                Vec2::Ones(),
                Vec2::Ones(),
                {},
                json.is_object() ? json.value("programs", Json::object()) : Json::object(),
                {},
                source,
                false};
  design.is_plain = root["groups"].elements_or_none(60).empty();
  if (design.rooms.empty()) root["for"].report("say of what kinds of rooms it is a design");
  if (const auto parameters = root["parameters"]; parameters.exists())
    for (const auto& [name, value] : parameters.members())
      if (design.parameters.size() < most_parameters)
        design.parameters.push_back(read_parameter(name, value));
  read_size(root["size_m"], design);
  for (const auto& palette : root["room"]["palettes"].elements_or_none(most_palettes)) {
    for (const auto& [role, word] : palette.members()) (void)word.text(100);
    design.palettes.push_back(*palette.raw());
  }
  root["concept"].text_or("", longest_text);
  (void)root["groups"].elements_or_none(60);
  (void)root["objects"].elements_or_none(100);
  (void)root["openings"].elements_or_none(20);
  if (problems.first()) return *problems.first();
  design.body = json;
  for (const char* member : own_members) design.body.erase(member);
  if (design.body.contains("room")) design.body["room"].erase("palettes");
  return design;
}

Result<Design> read_design(const Json& json, const std::string& source) {
  auto design = parse_design(json, source);
  if (!design) return design;
  Setting setting;
  setting.values = default_values(*design);
  setting.size = usual_size(*design, setting.values);
  if (!design->palettes.empty()) setting.palette = design->palettes.front();
  if (const auto answer = answer_of(*design, setting); !answer) return answer.error();
  return design;
}

Result<Design> read_design(const std::filesystem::path& path) {
  const auto text = read_file(path);
  if (!text) return text.error();
  const auto json = parse_json(*text, path.string());
  if (!json) return json.error();
  return read_design(*json, path.string());
}

}  // namespace roomgen::book
