#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/json_lines.h"
#include "base/json_reader.h"
#include "base/relative_name.h"
#include "roomgen/lab/questions.h"

namespace roomgen::lab {

namespace {

constexpr std::size_t most_question_bytes = 128u << 20;
constexpr std::size_t longest_level = 60;
constexpr double greatest_number = 1e9;

// Reports and plots show it.
bool is_level(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) || c == ' ' || c == '-' || c == '_'; });
}

SpatialQuestion question_from(const JsonReader& root) {
  SpatialQuestion question;
  question.id = root["id"].text();
  question.task = root["task"].text();
  question.form = root["form"].text();
  question.text = root["question"].text();
  for (const auto& choice : root["choices"].elements_or_none(100)) question.choices.push_back(choice.text());
  if (question.choices.empty()) {
    question.unit = root["unit"].text_or("");
    question.number = root["answer"].number(-greatest_number, greatest_number);
    question.tolerance = root["tolerance"].number(0.0, greatest_number);
  } else {
    question.right = static_cast<std::size_t>(
        root["answer_index"].integer_or(0, 0, static_cast<long long>(question.choices.size()) - 1));
    if (root["answer"].text() != question.choices[question.right]) root["answer"].report("is not the choice of answer_index");
  }
  for (const auto& frame : root["frames"].elements_or_none(100000))
    question.frames.push_back(static_cast<std::size_t>(frame.number(0, 1e9)));
  for (const auto& object : root["objects"].elements_or_none(100000)) question.objects.push_back(object.text());
  if (const auto arguments = root["arguments"]; arguments.exists()) question.arguments = *arguments.raw();
  if (const auto complexity = root["complexity"]; complexity.exists()) {
    for (const char* key : {"compositional", "relational", "observational"})
      if (!is_level(complexity[key].text_or("", longest_level))) complexity[key].report("a level has letters, digits, spaces, - and _ only");
    const std::string folder = complexity["folder"].text_or("");
    if (!folder.empty() && !stays_below(folder)) complexity["folder"].report("leads outside the set");
    question.complexity = *complexity.raw();
  }
  return question;
}

}  // namespace

Json to_json(const SpatialQuestion& question) {
  Json json = {{"id", question.id}, {"task", question.task}, {"form", question.form}, {"question", question.text}};
  if (question.choices.empty()) {
    json["unit"] = question.unit;
    // Counts are whole.
    json["answer"] = question.unit.empty() ? Json(std::llround(question.number)) : Json(question.number);
    json["tolerance"] = question.tolerance;
  } else {
    json["choices"] = question.choices;
    json["answer"] = question.choices.at(question.right);
    json["answer_index"] = question.right;
  }
  json["frames"] = question.frames;
  json["objects"] = question.objects;
  json["arguments"] = question.arguments;
  json["complexity"] = question.complexity;
  return json;
}

Result<std::vector<SpatialQuestion>> read_questions(const std::filesystem::path& path) {
  std::vector<SpatialQuestion> questions;
  const auto take = [&](const Json& json, const std::string& source) -> Status {
    JsonReader::Problems problems{source};
    questions.push_back(question_from(JsonReader(json, problems)));
    if (auto error = problems.first()) return *error;
    return {};
  };
  if (auto status = read_json_lines(path, most_question_bytes, take); !status) return status.error();
  return questions;
}

}  // namespace roomgen::lab
