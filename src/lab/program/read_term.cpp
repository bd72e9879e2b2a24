#include <nlohmann/json.hpp>

#include "face_names.h"
#include "form_operands.h"
#include "names.h"
#include "read_set.h"
#include "roomgen/base/text.h"

namespace roomgen::lab {

namespace {

double read_literal(const JsonReader& json) {
  return json.number(-program_limits::number, program_limits::number);
}

std::string read_variable(const JsonReader& json) {
  const std::string name = json.text(program_limits::name_bytes + 1);
  if (!is_program_name(name)) json.report("\"" + name + "\" cannot name a variable; give a word, without \"$\"");
  return name;
}

std::optional<Face> read_face(const JsonReader& json) {
  const std::string word = json.text(program_limits::name_bytes);
  const auto faces = faces_named(word);
  if (faces.size() > 1) json.report("\"" + word + "\" is several faces; name one of them");
  if (faces.empty()) json.report("\"" + word + "\" is no face" + suggestion(word, face_words()));
  return faces.empty() ? std::nullopt : std::optional(faces[0]);
}

void read_access(const JsonReader& json, ProgramTerm& term) {
  json.allow_only({"dir", "depth"});
  if (!json.is_object()) return;
  const std::string word = json["dir"].text_or(term.direction, program_limits::name_bytes);
  term.direction = direction_named(word);
  if (term.direction.empty())
    json["dir"].report("\"" + word + "\" is no direction" + suggestion(word, direction_words()));
  term.depth = json["depth"].number_or(term.depth, 0.01, 20.0);
}

void read_operand(char sort, const JsonReader& json, ReadingBudget& budget, int depth, ProgramTerm& term) {
  switch (sort) {
    case 'S': term.sets.push_back(read_set(json, budget)); break;
    case 'L':
      if (is_weighted(term.op)) term.number = read_literal(json);
      else term.literals.push_back(read_literal(json));
      break;
    case 'v': term.name = read_variable(json); break;
    case 's': term.face = read_face(json); break;
    case 'a': read_access(json, term); break;
    default: term.operands.push_back(read_term(json, budget, depth + 1));
  }
}

std::vector<std::string> op_names() {
  std::vector<std::string> names;
  for (const auto& form : program_op_forms()) names.emplace_back(form.name);
  return names;
}

const ProgramOpForm* read_op(const JsonReader& json) {
  const std::string name = json.text(program_limits::name_bytes);
  const auto* form = find_op_form(name);
  if (!form) json.report("\"" + name + "\" is no operator" + suggestion(name, op_names()));
  return form;
}

void read_operation(const JsonReader& json, ReadingBudget& budget, int depth, ProgramTerm& term) {
  const auto parts = json.elements(program_limits::operands + 1);
  if (parts.empty()) return json.report("expected [\"operator\", operands]");
  const auto* form = read_op(parts[0]);
  if (!form) return;
  term.op = form->op;
  const auto [least, most] = operand_count(*form);
  const std::size_t given = parts.size() - 1;
  if (given < least || given > most)
    return json.report(std::to_string(given) + " operands; expected " + usage(*form));
  for (std::size_t i = 0; i < given; ++i) read_operand(operand_at(*form, i), parts[i + 1], budget, depth, term);
}

void read_parameter(const JsonReader& json, ProgramTerm& term) {
  const std::string text = json.text(program_limits::name_bytes + 1);
  term.op = ProgramOp::parameter;
  if (!text.starts_with('@') || !is_program_name(text.substr(1)))
    return json.report("\"" + shortened(text, 40) + "\" is neither \"@parameter\" nor [\"operator\", operands]");
  term.name = text.substr(1);
}

}  // namespace

ProgramTerm read_term(const JsonReader& json, ReadingBudget& budget, int depth) {
  ProgramTerm term;
  term.at = json.pointer();
  if (!budget.admits(json, depth, program_limits::term_depth)) return term;
  if (json.is_array()) read_operation(json, budget, depth, term);
  else if (json.is_string()) read_parameter(json, term);
  else term.number = read_literal(json);
  return term;
}

}  // namespace roomgen::lab
