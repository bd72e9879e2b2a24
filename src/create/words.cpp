#include "words.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "description_words.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen::create {

namespace {

constexpr const char* words_path = "data/create/words.json";

WordMap<std::string> read_texts(const JsonReader& json) {
  WordMap<std::string> result;
  for (const auto& [word, value] : json.members()) result[word] = value.text();
  return result;
}

WordSet read_list(const JsonReader& json) {
  WordSet result;
  for (const auto& element : json.elements()) result.insert(element.text());
  return result;
}

// Of width, depth and height.
WordMap<Vec3> read_factors(const JsonReader& json) {
  WordMap<Vec3> result;
  for (const auto& [word, value] : json.members()) {
    const auto factors = value.numbers(3, 0.1, 10);
    if (factors.size() == 3) result[word] = Vec3(factors[0], factors[1], factors[2]);
  }
  return result;
}

std::optional<Place> read_place(const JsonReader& json) {
  if (!json.exists()) return std::nullopt;
  const auto place = place_named(json.text());
  if (!place) json.report("is no place");
  return place;
}

void read_placement(const JsonReader& json, std::vector<Placement>& placements) {
  json.allow_only({"say", "before", "after", "each", "scale", "turn"});
  Placement placement;
  placement.before = read_place(json["before"]);
  const std::string after = json["after"].text_or("");
  placement.below = after == "below";
  placement.gone = after == "gone";
  if (!placement.below && !placement.gone) placement.after = read_place(json["after"]);
  placement.each = static_cast<int>(json["each"].integer_or(1, 1, 4));
  placement.series = {json["scale"].number_or(1, 0.2, 3), radians(json["turn"].number_or(0, 0, 180))};
  for (const auto& phrase : json["say"].elements()) {
    placement.words = split(phrase.text(), ' ');
    placements.push_back(placement);
  }
}

Result<Words> read() {
  const auto json = parse_json(resource(words_path).value_or(""), words_path);
  if (!json) return json.error();
  JsonReader::Problems problems{words_path};
  const JsonReader root(*json, problems);
  Words words;
  words.shapes = read_texts(root["shapes"]);
  words.constructions = read_texts(root["constructions"]);
  words.styles = read_texts(root["styles"]);
  for (const auto& [word, value] : root["leans"].members()) words.leans[word] = value.number(0, 60);
  for (const auto& [word, value] : root["courses"].members()) {
    const auto course = course_named(value.text());
    if (!course) value.report("is no course");
    words.courses[word] = course.value_or(Course::straight);
  }
  for (const auto& [word, value] : root["strengths"].members()) {
    const auto strength = strength_named(value.text());
    if (!strength) value.report("is no strength");
    words.strengths[word] = strength.value_or(Strength::moderate);
  }
  words.scales = read_factors(root["scales"]);
  words.comparatives = read_factors(root["comparatives"]);
  for (const auto& [word, value] : root["materials"].members())
    words.materials[word] = read_substance(word, value);
  words.directions = read_list(root["directions"]);
  words.far_things = read_list(root["vehicles and nature"]);
  words.beings = read_list(root["living beings"]);
  words.no_objects = read_list(root["no objects"]);
  words.owners = read_list(root["owners"]);
  words.purposes = read_list(root["purposes"]);
  words.comparisons = read_list(root["comparisons"]);
  words.absences = read_list(root["absences"]);
  words.fillers = read_list(root["fillers"]);
  words.orders = read_list(root["orders"]);
  words.rooms = read_list(root["rooms"]);
  words.makings = read_list(root["makings"]);
  words.likenesses = read_list(root["likenesses"]);
  words.distances = read_list(root["distances"]);
  for (const auto& pair : root["relations"].elements())
    if (const auto texts = pair.elements(2); texts.size() == 2)
      words.relations.emplace_back(split(texts[0].text(), ' '), texts[1].text());
  for (const auto& placement : root["placements"].elements())
    read_placement(placement, words.placements);
  std::stable_sort(words.placements.begin(), words.placements.end(), [](const auto& a, const auto& b) {
    return a.words.size() > b.words.size();
  });
  for (const auto& [word, place] : root["arrangements"].members())
    words.arrangements[word] = read_place(place).value_or(Place::stack);
  for (const auto& simile : root["similes"].elements())
    words.similes.push_back(split(simile.text(), ' '));
  if (const auto& problem = problems.first()) return *problem;
  return words;
}

}  // namespace

shape::Surface read_substance(const std::string& name, const JsonReader& json) {
  json.allow_only({"color", "roughness", "metalness", "opacity", "pattern", "scale"});
  shape::Surface surface;
  surface.name = name;
  surface.color = json["color"].text();
  surface.roughness = json["roughness"].number_or(0.7, 0.0, 1.0);
  surface.metalness = json["metalness"].number_or(0.0, 0.0, 1.0);
  surface.opacity = json["opacity"].number_or(1.0, 0.05, 1.0);
  surface.pattern = json["pattern"].text_or("none");
  surface.scale = json["scale"].number_or(1.0, 0.05, 20.0);
  return surface;
}

const Result<Words>& built_in_words() {
  static const Result<Words> words = read();
  return words;
}

}  // namespace roomgen::create
