#include "forms.h"

#include <nlohmann/json.hpp>

#include "base/resource.h"
#include "roomgen/base/json.h"
#include "roomgen/lab/questions.h"

namespace roomgen::lab {

namespace detail {

namespace {

QuestionForms read_forms() {
  const Json json = *parse_json(resource("data/questions/forms.json").value_or("{}"), "data/questions/forms.json");
  QuestionForms result;
  const Json& picture = json.at("picture");
  result.limits = {picture.at("clear"), picture.at("seen"), picture.at("faint")};
  for (const auto& [name, form] : json.at("forms").items()) {
    QuestionForm& one = result.forms[name];
    one.task = form.at("task");
    one.unit = form.value("unit", "");
    one.tolerance = form.value("tolerance", 0.0);
    one.least_tolerance = form.value("least tolerance", 0.0);
    one.texts = form.at("texts").get<std::vector<std::string>>();
  }
  for (const auto& [name, words] : json.at("words").items()) result.words[name] = words;
  result.no_color = json.at("no color").get<std::vector<std::string>>();
  return result;
}

}  // namespace

const QuestionForms& question_forms() {
  static const QuestionForms forms = read_forms();
  return forms;
}

std::string filled_inside(std::string text, const Fillings& fillings) {
  for (const auto& [place, words] : fillings) {
    const std::string braced = "{" + place + "}";
    for (std::size_t at = text.find(braced); at != std::string::npos; at = text.find(braced, at + words.size()))
      text.replace(at, braced.size(), words);
  }
  return text;
}

std::string filled(std::string text, const Fillings& fillings) {
  text = filled_inside(std::move(text), fillings);
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

}  // namespace detail

std::vector<std::string> question_tasks() { return {"measurement", "perspective", "spatiotemporal", "relation", "control"}; }

}  // namespace roomgen::lab
