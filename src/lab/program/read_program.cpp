#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "face_names.h"
#include "names.h"
#include "read_set.h"
#include "roomgen/base/file.h"
#include "scene/file_limits.h"

namespace roomgen::lab {

namespace {

constexpr std::string_view program_format = "roomgen-program";
constexpr long long program_version = 1;
constexpr double most_margin = 10.0;  // metres

// Members whose keys are names that the program gives.
std::vector<std::pair<std::string, JsonReader>> named_members(const JsonReader& json) {
  auto members = json.members();
  if (members.size() > program_limits::names) {
    json.report("more than " + std::to_string(program_limits::names) + " of them");
    return {};
  }
  for (const auto& [key, value] : members)
    if (!is_program_name(key))
      json.report("\"" + key + "\" cannot be a name: it is empty or long, has one of / ~ $ @ \" \\ or begins with -");
  return members;
}

ProgramParameter read_parameter_values(const JsonReader& json) {
  ProgramParameter parameter;
  if (!json.is_object()) {
    parameter.choice = {json.number(-program_limits::number, program_limits::number)};
    return parameter;
  }
  json.allow_only({"uniform", "choice"});
  const auto uniform = json["uniform"], choice = json["choice"];
  if (uniform.exists() == choice.exists())
    json.report("expected a number, {\"uniform\": [low, high]} or {\"choice\": [numbers]}");
  else if (uniform.exists()) {
    const auto ends = uniform.numbers(2, -program_limits::number, program_limits::number);
    parameter.uniform = Range{ends[0], ends[1]};
  }
  for (const auto& value : choice.elements_or_none(program_limits::operands))
    parameter.choice.push_back(value.number(-program_limits::number, program_limits::number));
  if (choice.exists() && parameter.choice.empty()) choice.report("a choice of nothing");
  return parameter;
}

std::vector<Face> read_faces(const JsonReader& json) {
  std::vector<Face> faces;
  for (const auto& element : json.elements(face_words().size())) {
    const std::string word = element.text(program_limits::name_bytes);
    const auto named = faces_named(word);
    if (named.empty()) element.report("\"" + word + "\" is no face" + suggestion(word, face_words()));
    faces.insert(faces.end(), named.begin(), named.end());
  }
  if (faces.empty()) json.report("expected at least one face");
  return faces;
}

PutUp read_put_up(const JsonReader& json) {
  json.allow_only({"type", "child", "parent", "margin", "check_z"});
  PutUp put_up;
  const std::string type = json["type"].text(program_limits::name_bytes);
  if (type == "coplanar") put_up.type = PutUp::Type::coplanar;
  else if (type != "stable_against") json["type"].report("must be \"stable_against\" or \"coplanar\"");
  put_up.child = read_faces(json["child"]);
  put_up.parent = read_faces(json["parent"]);
  put_up.margin = json["margin"].number_or(0.0, 0.0, most_margin);
  put_up.within_height = json["check_z"].boolean_or(true);
  return put_up;
}

NamedSets read_sets(const JsonReader& json, ReadingBudget& budget) {
  NamedSets sets;
  for (const auto& [name, set] : named_members(json)) {
    if (is_given_set(name)) json.report("every program has a set \"" + name + "\" already");
    sets.emplace_back(name, read_set(set, budget));
  }
  return sets;
}

NamedTerms read_terms(const JsonReader& json, ReadingBudget& budget) {
  NamedTerms terms;
  for (const auto& [name, term] : named_members(json)) terms.emplace_back(name, read_term(term, budget));
  return terms;
}

void read_format(const JsonReader& root) {
  const std::string format = root["format"].text_or(std::string(program_format), program_limits::name_bytes);
  if (format != program_format)
    root["format"].report("\"" + format + "\" is not \"" + std::string(program_format) + "\"");
  if (root["version"].integer_or(program_version, 0, 1000000) != program_version)
    root["version"].report("only version " + std::to_string(program_version) + " is known");
}

ConstraintProgram read_document(const JsonReader& root) {
  root.allow_only({"format", "version", "prompt", "seed", "room", "params", "relations", "sets", "constraints",
                   "scores"});
  read_format(root);
  ConstraintProgram program;
  program.prompt = root["prompt"].text_or("", 100000);
  program.seed = static_cast<std::uint64_t>(root["seed"].integer_or(0, 0, max_seed));
  program.room = read_room_wish(root["room"]);
  for (const auto& [name, value] : named_members(root["params"]))
    program.parameters[name] = read_parameter_values(value);
  for (const auto& [name, value] : named_members(root["relations"])) program.relations[name] = read_put_up(value);
  ReadingBudget budget;
  program.sets = read_sets(root["sets"], budget);
  program.constraints = read_terms(root["constraints"], budget);
  program.scores = read_terms(root["scores"], budget);
  return program;
}

}  // namespace

bool is_program(const Json& json) {
  if (!json.is_object()) return false;
  if (const auto format = json.find("format"); format != json.end()) return *format == program_format;
  return json.contains("constraints") && json.contains("sets");
}

Result<ConstraintProgram> program_from_json(const Json& json, const std::string& source) {
  JsonReader::Problems problems(source);
  const JsonReader root(json, problems);
  if (!root.is_object()) {
    root.report("expected an object with \"room\", \"sets\", \"constraints\" and \"scores\"");
    return *problems.first();
  }
  ConstraintProgram program = read_document(root);
  if (problems.first()) return *problems.first();
  program.source = source;
  return program;
}

Result<ConstraintProgram> read_program(const std::filesystem::path& path) {
  auto text = read_file(path);
  if (!text) return text.error();
  auto json = parse_json(*text, path.string());
  if (!json) return json.error();
  return program_from_json(*json, path.string());
}

}  // namespace roomgen::lab
