#include "roomgen/lab/suite.h"

#include <array>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/sha256.h"
#include "roomgen/base/text.h"

namespace roomgen::lab {

namespace {

constexpr std::array<const char*, check_count> check_names = {
    "connected", "grounded", "supported", "symmetric", "stable", "size"};
constexpr std::array<std::pair<const char*, Mount>, 4> mount_names = {
    {{"floor", Mount::floor},
     {"wall", Mount::wall},
     {"ceiling", Mount::ceiling},
     {"surface", Mount::surface}}};
constexpr int most_parts = 1000;
constexpr double largest = 100.0;  // metres
constexpr std::size_t most_failures = 200;

WantedPart read_part(const JsonReader& json) {
  WantedPart part;
  part.labels = split(lower(json["label"].text()), '|');
  const JsonReader count = json["count"];
  if (count.is_array()) {
    const auto ends = count.numbers(2, 0, most_parts);
    part.least = static_cast<int>(ends[0]);
    part.most = static_cast<int>(ends[1]);
  } else if (count.exists()) {
    part.least = static_cast<int>(count.integer_or(1, 0, most_parts));
    part.most = part.least;
  }
  return part;
}

Mount read_mount(const JsonReader& json) {
  const std::string said = json.text_or("floor");
  for (const auto& [word, mount] : mount_names)
    if (said == word) return mount;
  json.report("expected floor, wall, ceiling or surface");
  return Mount::floor;
}

SuiteSentence read_sentence(const JsonReader& json) {
  SuiteSentence sentence;
  sentence.prompt = json["prompt"].text();
  sentence.group = json["group"].text_or("all");
  sentence.mount = read_mount(json["mount"]);
  for (const auto& part : json["parts"].elements()) sentence.parts.push_back(read_part(part));
  const auto sides = json["size"].elements();
  if (sides.size() != 3) json["size"].report("expected [least, most] of width, depth and height");
  for (std::size_t axis = 0; axis < std::min<std::size_t>(3, sides.size()); ++axis) {
    const auto range = sides[axis].numbers(2, 0, largest);
    sentence.least[static_cast<Eigen::Index>(axis)] = range[0];
    sentence.most[static_cast<Eigen::Index>(axis)] = range[1];
  }
  return sentence;
}

Score read_score(const JsonReader& json) {
  Score score;
  score.points = static_cast<int>(json["points"].integer_or(1, 1, 5));
  score.reason = json["reason"].text_or("");
  return score;
}

}  // namespace

const char* name(Check check) {
  return check_names[static_cast<std::size_t>(check)];
}

std::string suite_version(std::string_view text) {
  return sha256_hex(text);
}

Result<std::vector<SuiteSentence>> read_suite(const Json& json, const std::string& source) {
  JsonReader::Problems problems(source);
  std::vector<SuiteSentence> suite;
  for (const auto& entry : JsonReader(json, problems).elements())
    suite.push_back(read_sentence(entry));
  if (suite.empty() && !problems.first()) problems.add("", "holds no sentences");
  if (auto error = problems.first()) return *error;
  return suite;
}

Json to_json(const SuiteResult& result) {
  const Assessment& found = result.assessment;
  Json json = {{"variant", name(result.variant)},
               {"number", result.number},
               {"prompt", result.prompt},
               {"group", result.group},
               {"made", found.made},
               {"parts_right", found.parts_right},
               {"parts_asked", found.parts_asked}};
  for (std::size_t k = 0; k < check_count; ++k)
    json[check_names[k]] = found.checks[k] ? Json(*found.checks[k]) : Json();
  json["extent"] = {rounded(result.size.x()), rounded(result.size.y()), rounded(result.size.z())};
  json["triangles"] = result.triangles;
  json["repairs"] = result.repairs;
  json["by_rules"] = result.fell_back;
  json["seconds"] = rounded(result.seconds, 3);
  if (result.scores) json["scores"] = to_json(*result.scores);
  json["failures"] = found.failures;
  return json;
}

Result<SuiteResult> suite_result_from_json(const Json& json, const std::string& source) {
  JsonReader::Problems problems(source);
  const JsonReader root(json, problems);
  SuiteResult result;
  const auto variant = create::variant_named(root["variant"].text());
  if (!variant) root["variant"].report("expected a variant");
  result.variant = variant.value_or(Variant::full);
  result.number = static_cast<int>(root["number"].integer_or(0, 1, 1'000'000));
  result.prompt = root["prompt"].text();
  result.group = root["group"].text();
  Assessment& found = result.assessment;
  found.made = root["made"].boolean_or(false);
  found.parts_right = static_cast<int>(root["parts_right"].integer_or(0, 0, most_parts));
  found.parts_asked = static_cast<int>(root["parts_asked"].integer_or(0, 0, most_parts));
  for (std::size_t k = 0; k < check_count; ++k)
    if (const JsonReader check = root[check_names[k]]; check.exists())
      found.checks[k] = check.boolean_or(false);
  const auto extent = root["extent"].numbers(3, 0, largest);
  result.size = Vec3(extent[0], extent[1], extent[2]);
  result.triangles = static_cast<std::size_t>(root["triangles"].integer_or(0, 0, 1'000'000'000));
  result.repairs = static_cast<int>(root["repairs"].integer_or(0, 0, 1'000'000));
  result.fell_back = root["by_rules"].boolean_or(false);
  result.seconds = root["seconds"].number_or(0, 0, 1e9);
  if (const JsonReader scores = root["scores"]; scores.exists())
    result.scores = Scores{read_score(scores["structure"]), read_score(scores["realism"]),
                           read_score(scores["alignment"])};
  for (const auto& failure : root["failures"].elements_or_none(most_failures))
    found.failures.push_back(failure.text());
  if (auto error = problems.first()) return *error;
  return result;
}

}  // namespace roomgen::lab
