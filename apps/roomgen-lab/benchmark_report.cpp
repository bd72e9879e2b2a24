#include "benchmark_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "roomgen/base/text.h"

namespace roomgen::cli {

using namespace lab;

namespace {

constexpr double z95 = 1.959964;  // of the normal distribution, two-sided 95 %
constexpr const char* factors[] = {"compositional", "relational", "observational"};

// Accuracy and the ends of its interval, from 0 to 1.
struct Figure {
  std::size_t count = 0;
  double mean = 0.0, low = 0.0, high = 1.0;
};

// Of shares of right answers after Wilson (1927), which a mean of scores in [0, 1] never exceeds in width.
Figure figure_of(const std::vector<double>& scores) {
  Figure figure;
  figure.count = scores.size();
  if (scores.empty()) return figure;
  const auto n = static_cast<double>(scores.size());
  for (const double score : scores) figure.mean += score / n;
  const double middle = (figure.mean + z95 * z95 / (2 * n)) / (1 + z95 * z95 / n);
  const double spread = z95 / (1 + z95 * z95 / n) *
                        std::sqrt(figure.mean * (1 - figure.mean) / n + z95 * z95 / (4 * n * n));
  figure.low = std::max(0.0, middle - spread);
  figure.high = std::min(1.0, middle + spread);
  return figure;
}

std::string percent(double share) { return format_number(100.0 * share, 1); }

std::string cell_text(const Figure& figure) {
  if (figure.count == 0) return "";
  return percent(figure.mean) + " (" + percent(figure.low) + " to " + percent(figure.high) + ", n = " +
         std::to_string(figure.count) + ")";
}

std::string level_of(const SpatialQuestion& question, const std::string& factor) {
  const Json& complexity = question.complexity;
  return complexity.is_object() && complexity.contains(factor) ? complexity.at(factor).get<std::string>() : "";
}

// What a table and a plot have room for.
constexpr std::size_t most_levels = 20;

// low, medium, high, then others; the first of them if there are many.
std::vector<std::string> levels_of(const std::vector<ScoredQuestion>& scored, const std::string& factor) {
  const std::vector<std::string> order = {"low", "medium", "high"};
  std::set<std::pair<std::ptrdiff_t, std::string>> sorted;
  for (const auto& one : scored)
    if (auto level = level_of(*one.question, factor); !level.empty()) {
      const auto place = std::find(order.begin(), order.end(), level) - order.begin();
      sorted.emplace(place, std::move(level));
      if (sorted.size() > most_levels) sorted.erase(std::prev(sorted.end()));
    }
  std::vector<std::string> levels;
  for (const auto& [place, level] : sorted) levels.push_back(level);
  return levels;
}

template <typename Wanted>
Figure figure_where(const std::vector<ScoredQuestion>& scored, const Wanted& wanted, double AnswerScore::* value) {
  std::vector<double> scores;
  for (const auto& one : scored)
    if (wanted(*one.question)) scores.push_back(one.score.*value);
  return figure_of(scores);
}

std::vector<std::string> tasks_in(const std::vector<ScoredQuestion>& scored) {
  std::vector<std::string> tasks;
  for (const auto& task : question_tasks())
    if (std::any_of(scored.begin(), scored.end(), [&](const auto& one) { return one.question->task == task; }))
      tasks.push_back(task);
  return tasks;
}

std::string table_over(const std::vector<ScoredQuestion>& scored, const std::string& factor) {
  const auto levels = levels_of(scored, factor);
  if (levels.empty()) return "";
  std::string table = "\n## Over " + factor + " complexity\n\n| task |";
  for (const auto& level : levels) table += " " + level + " |";
  table += "\n|---|";
  for (std::size_t k = 0; k < levels.size(); ++k) table += "---|";
  table += "\n";
  for (const auto& task : tasks_in(scored)) {
    table += "| " + task + " |";
    for (const auto& level : levels)
      table += " " + cell_text(figure_where(scored, [&](const SpatialQuestion& question) {
                 return question.task == task && level_of(question, factor) == level;
               }, &AnswerScore::mean_relative)) + " |";
    table += "\n";
  }
  return table;
}

}  // namespace

std::string benchmark_report(const std::vector<ScoredQuestion>& scored) {
  const auto read = std::count_if(scored.begin(), scored.end(), [](const auto& one) { return one.score.read; });
  std::string report = "# Answers\n\n" + std::to_string(scored.size()) + " questions, " + std::to_string(read) +
                       " answers that could be read. Per cent, with 95 % intervals. Mean relative accuracy of numbers, "
                       "share of right answers of choices (docs/questions.md).\n\n| task | mean relative accuracy | exact | "
                       "relative accuracy |\n|---|---|---|---|\n";
  for (const auto& task : tasks_in(scored)) {
    const auto of_task = [&](const SpatialQuestion& question) { return question.task == task; };
    report += "| " + task + " | " + cell_text(figure_where(scored, of_task, &AnswerScore::mean_relative)) + " | " +
              cell_text(figure_where(scored, of_task, &AnswerScore::exact)) + " | " +
              cell_text(figure_where(scored, of_task, &AnswerScore::relative)) + " |\n";
  }
  for (const char* factor : factors) report += table_over(scored, factor);
  return report;
}

std::string benchmark_plot(const std::vector<ScoredQuestion>& scored, const std::string& factor) {
  constexpr double left = 60, top = 20, width = 360, height = 220;
  static const std::vector<std::string> colors = {"#c0392b", "#2c6fbb", "#2e8b57", "#8e44ad", "#b8860b"};
  const auto levels = levels_of(scored, factor);
  const auto tasks = tasks_in(scored);
  if (levels.size() < 2) return "";
  const auto x = [&](std::size_t level) { return left + width * (static_cast<double>(level) + 0.5) / static_cast<double>(levels.size()); };
  const auto y = [&](double share) { return top + height * (1.0 - share); };
  const auto at = [](double value) { return format_number(value, 1); };
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"580\" height=\"300\" font-family=\"sans-serif\" "
                    "font-size=\"12\">\n<rect width=\"580\" height=\"300\" fill=\"white\"/>\n";
  for (int tenth = 0; tenth <= 10; tenth += 2)
    svg += "<line x1=\"" + at(left) + "\" x2=\"" + at(left + width) + "\" y1=\"" + at(y(0.1 * tenth)) + "\" y2=\"" +
           at(y(0.1 * tenth)) + "\" stroke=\"#ddd\"/><text x=\"" + at(left - 36) + "\" y=\"" + at(y(0.1 * tenth) + 4) +
           "\">" + std::to_string(10 * tenth) + " %</text>\n";
  for (std::size_t k = 0; k < levels.size(); ++k)
    svg += "<text text-anchor=\"middle\" x=\"" + at(x(k)) + "\" y=\"" + at(top + height + 18) + "\">" + levels[k] + "</text>\n";
  svg += "<text text-anchor=\"middle\" x=\"" + at(left + width / 2) + "\" y=\"" + at(top + height + 40) + "\">" + factor + " complexity</text>\n";
  for (std::size_t t = 0; t < tasks.size(); ++t) {
    const std::string& color = colors[t % colors.size()];
    const double aside = 5.0 * (static_cast<double>(t) - 0.5 * static_cast<double>(tasks.size() - 1));
    std::string points;
    for (std::size_t k = 0; k < levels.size(); ++k) {
      const Figure figure = figure_where(scored, [&](const SpatialQuestion& question) {
        return question.task == tasks[t] && level_of(question, factor) == levels[k];
      }, &AnswerScore::mean_relative);
      if (figure.count == 0) continue;
      points += at(x(k) + aside) + "," + at(y(figure.mean)) + " ";
      svg += "<line x1=\"" + at(x(k) + aside) + "\" x2=\"" + at(x(k) + aside) + "\" y1=\"" + at(y(figure.low)) + "\" y2=\"" +
             at(y(figure.high)) + "\" stroke=\"" + color + "\"/>\n";
    }
    svg += "<polyline fill=\"none\" stroke-width=\"2\" stroke=\"" + color + "\" points=\"" + points + "\"/>\n<text x=\"" +
           at(left + width + 14) + "\" y=\"" + at(top + 16.0 * static_cast<double>(t + 1)) + "\" fill=\"" + color + "\">" + tasks[t] + "</text>\n";
  }
  return svg + "</svg>\n";
}

}  // namespace roomgen::cli
