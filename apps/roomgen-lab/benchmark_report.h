#pragma once

#include <string>
#include <vector>

#include "roomgen/lab/questions.h"

namespace roomgen::cli {

/// A question, and how well it was answered.
struct ScoredQuestion {
  const lab::SpatialQuestion* question;
  AnswerScore score;
};

/// Tables of accuracy by task and by level of each factor, in Markdown, each figure with its 95 % interval.
std::string benchmark_report(const std::vector<ScoredQuestion>& scored);

/// Accuracy of each task over the levels of a factor ("compositional"), as SVG; empty if there are no two levels.
std::string benchmark_plot(const std::vector<ScoredQuestion>& scored, const std::string& factor);

}  // namespace roomgen::cli
