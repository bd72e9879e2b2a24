#pragma once

#include <map>
#include <string>
#include <vector>

#include "appearances.h"

namespace roomgen::lab::detail {

/// How questions of one form are put (data/questions/forms.json).
struct QuestionForm {
  std::string task, unit;
  double tolerance = 0.0, least_tolerance = 0.0;
  std::vector<std::string> texts;
};

struct QuestionForms {
  SightLimits limits;
  std::map<std::string, QuestionForm> forms;
  std::map<std::string, std::string> words;
  std::vector<std::string> no_color;  ///< kinds of which people name the colour of one part or another
};

const QuestionForms& question_forms();

using Fillings = std::map<std::string, std::string>;
/// The text with each {place} filled, its first letter large.
std::string filled(std::string text, const Fillings& fillings);
/// The same inside a sentence.
std::string filled_inside(std::string text, const Fillings& fillings);

}  // namespace roomgen::lab::detail
