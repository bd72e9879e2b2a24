#include <algorithm>
#include <cmath>
#include <regex>

#include "roomgen/base/text.h"
#include "roomgen/lab/questions.h"

namespace roomgen::lab {

namespace {

constexpr std::size_t most_answer = 20000;  // bytes that are looked at, from the end
constexpr int thresholds = 10;
constexpr double first_threshold = 0.5, threshold_step = 0.05;

// The last line with something on it comes first: models reason before they answer.
std::vector<std::string> lines_from_the_end(std::string_view answer) {
  if (answer.size() > most_answer) answer.remove_prefix(answer.size() - most_answer);
  auto lines = split(answer, '\n');
  std::erase_if(lines, [](const std::string& line) { return line.empty(); });
  std::reverse(lines.begin(), lines.end());
  return lines;
}

std::optional<double> number_in(const std::string& line) {
  static const std::regex pattern(R"([-+]?\d+(?:[.,]\d+)?)");
  std::smatch found;
  if (!std::regex_search(line, found, pattern)) return std::nullopt;
  std::string text = found.str();
  std::replace(text.begin(), text.end(), ',', '.');
  try {
    return std::stod(text);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

// "B", "(b)", "B. the sofa", "Answer: B"
std::optional<std::size_t> letter_in(const std::string& line, std::size_t choices) {
  static const std::regex pattern(R"((?:^|answer(?: is)?:?\s*|\()\(?([A-Z])(?:[).:\s]|$))", std::regex::icase);
  std::smatch found;
  if (!std::regex_search(line, found, pattern)) return std::nullopt;
  const auto index = static_cast<std::size_t>(std::toupper(static_cast<unsigned char>(found[1].str()[0])) - 'A');
  return index < choices ? std::optional(index) : std::nullopt;
}

// The only choice whose text it has, or the longest of those that hold each other.
std::optional<std::size_t> text_in(const std::string& line, const std::vector<std::string>& choices) {
  const std::string text = lower(line);
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < choices.size(); ++k) {
    const std::string choice = lower(choices[k]);
    if (text.find(choice) == std::string::npos) continue;
    if (!best) {
      best = k;
      continue;
    }
    const std::string other = lower(choices[*best]);
    if (choice.find(other) != std::string::npos)
      best = k;
    else if (other.find(choice) == std::string::npos)
      return std::nullopt;
  }
  return best;
}

double share_of_thresholds(double off) {
  int met = 0;
  for (int k = 0; k < thresholds; ++k) met += off < 1.0 - (first_threshold + threshold_step * k) - 1e-12;
  return static_cast<double>(met) / thresholds;
}

AnswerScore score_number(const SpatialQuestion& question, double value) {
  AnswerScore score;
  score.read = true;
  const double error = std::abs(value - question.number), truth = std::abs(question.number);
  score.exact = error <= question.tolerance + 1e-9 ? 1.0 : 0.0;
  score.mean_relative = share_of_thresholds(error / std::max(truth, 1e-9));
  score.relative = std::max(0.0, 1.0 - error / std::max(truth, question.unit.empty() ? 1.0 : 0.001));
  return score;
}

}  // namespace

AnswerScore score_answer(const SpatialQuestion& question, std::string_view answer) {
  for (const auto& line : lines_from_the_end(answer)) {
    if (question.choices.empty()) {
      if (const auto value = number_in(line)) return score_number(question, *value);
      continue;
    }
    auto choice = letter_in(line, question.choices.size());
    if (const auto text = text_in(line, question.choices)) choice = text;
    if (!choice) continue;
    const double right = *choice == question.right ? 1.0 : 0.0;
    return {true, right, right, right};
  }
  return {};
}

}  // namespace roomgen::lab
