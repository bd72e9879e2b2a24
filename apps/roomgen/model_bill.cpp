#include "model_bill.h"

#include <nlohmann/json.hpp>

#include "roomgen/base/text.h"
#include "roomgen/design/designer.h"

namespace roomgen::cli {

namespace {

// Of a replay: the plan's and all places'.
ChatTotals recorded_totals(const ComposedDesigner& composed, const ModelUse& places) {
  const Consultation planning = composed.designer->plan_consultation();
  ChatTotals totals;
  totals.calls = places.calls + planning.calls;
  totals.input_tokens = places.input_tokens + planning.input_tokens;
  totals.output_tokens = places.output_tokens + planning.output_tokens;
  totals.seconds = places.seconds + planning.seconds;
  return totals;
}

ChatTotals totals_of(const ComposedDesigner& composed, const Generation& generation) {
  return composed.limited ? composed.limited->totals()
                          : recorded_totals(composed, generation.model_use);
}

// "3 calls, 1500 + 12288 tokens (estimated for 1 of the calls), 0.1266 dollars, 2.0 s"
std::string totals_text(const ChatTotals& totals) {
  std::string text = std::to_string(totals.calls) + (totals.calls == 1 ? " call, " : " calls, ") +
                     std::to_string(totals.input_tokens) + " + " +
                     std::to_string(totals.output_tokens) + " tokens";
  if (totals.estimated_calls > 0)
    text += " (estimated for " + std::to_string(totals.estimated_calls) + " of the calls)";
  if (totals.dollars) text += ", " + format_number(*totals.dollars, 4) + " dollars";
  return text + ", " + format_number(totals.seconds, 1) + " s";
}

// Why rules made the plan, or placed the first thing that they did; empty where they did neither.
std::string why_rules(const ComposedDesigner& composed, const Generation& generation) {
  const Consultation planning = composed.designer->plan_consultation();
  if (planning.fell_back && !planning.notes.empty()) return planning.notes.back();
  for (const auto& step : generation.trace)
    for (const auto& attempt : step.attempts) {
      const Consultation& consultation = attempt.answer.consultation;
      if (consultation.fell_back && !consultation.notes.empty()) return consultation.notes.back();
    }
  return {};
}

}  // namespace

std::vector<std::string> bill_lines(const ComposedDesigner& composed,
                                    const Generation& generation) {
  const bool plan_by_rules = composed.designer->plan_consultation().fell_back;
  const SuggestionFigures& figures = generation.suggestions;
  std::vector<std::string> lines = {
      "  the model: " + totals_text(totals_of(composed, generation)) + "; rules made " +
          (plan_by_rules ? "the plan and " : "") + std::to_string(generation.model_use.fallbacks) +
          " of the places",
      "  of " + std::to_string(figures.located) + " suggested places " +
          std::to_string(figures.within[1]) + " were followed within 0.5 m (" +
          std::to_string(figures.placed_within[1]) + " when placed), " +
          std::to_string(figures.within[2]) + " within 1 m"};
  if (const auto why = why_rules(composed, generation); !why.empty())
    lines.push_back("  why rules: " + why);
  if (!generation.stopped.empty()) lines.push_back("  stopped: " + generation.stopped);
  return lines;
}

Json bill_json(const ComposedDesigner& composed, const Generation& generation) {
  const ChatTotals totals = totals_of(composed, generation);
  Json json = {{"calls", totals.calls},
               {"estimated_calls", totals.estimated_calls},
               {"input_tokens", totals.input_tokens},
               {"output_tokens", totals.output_tokens},
               {"seconds", rounded(totals.seconds, 3)},
               {"plan_by_rules", composed.designer->plan_consultation().fell_back},
               {"fallbacks", generation.model_use.fallbacks},
               {"why_rules", why_rules(composed, generation)},
               {"stopped", generation.stopped}};
  if (totals.dollars) json["dollars"] = rounded(*totals.dollars, 6);
  return json;
}

Error with_bill(const Error& error, const ComposedDesigner& composed) {
  if (!composed.limited || composed.limited->totals().calls == 0) return error;
  return {error.kind,
          error.message + " (the model: " + totals_text(composed.limited->totals()) + ")"};
}

}  // namespace roomgen::cli
