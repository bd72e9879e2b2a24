#include "form_operands.h"

#include <algorithm>

#include "limits.h"

namespace roomgen::lab {

namespace {

std::string operand_word(char c) {
  switch (c) {
    case 'S': return "SET";
    case 'N': return "NUMBER";
    case 'B': return "TRUTH";
    case 'L': return "LITERAL";
    case 'v': return "\"variable\"";
    case 's': return "FACE?";
    default: return "{\"dir\", \"depth\"}?";
  }
}

}  // namespace

OperandCount operand_count(const ProgramOpForm& form) {
  OperandCount count;
  for (const char c : form.operands) {
    if (c == '+') return {count.least, program_limits::operands};
    if (c != 's' && c != 'a') ++count.least;
    ++count.most;
  }
  return count;
}

char operand_at(const ProgramOpForm& form, std::size_t index) {
  if (form.operands.back() != '+') return form.operands[index];
  return form.operands[std::min(index, form.operands.size() - 2)];
}

std::string usage(const ProgramOpForm& form) {
  std::string text = "[\"" + std::string(form.name) + "\"";
  for (const char c : form.operands) text += c == '+' ? ", ..." : ", " + operand_word(c);
  return text + "]";
}

}  // namespace roomgen::lab
