#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "roomgen/base/text.h"
#include "roomgen/lab/compose.h"
#include "roomgen/evaluate/report.h"

namespace roomgen::lab {

namespace {

constexpr double exact = 1e-9;

double missed_by(const Range& range, double value) {
  return std::max({0.0, range.low - value, std::isinf(range.high) ? 0.0 : value - range.high});
}

Json range_json(const Range& range) {
  return Json::array({range.low, std::isinf(range.high) ? Json(nullptr) : Json(range.high)});
}

}  // namespace

double measured(std::string_view measure, const Scene& scene, double occupancy, const KindTable& kinds) {
  const auto& vocabulary = ProgramVocabulary::built_in();
  const auto sum_of = [&](const auto& worth) {
    double sum = 0.0;
    for (const auto& object : scene.objects) sum += worth(kinds.get(object.category), object.size.x());
    return sum;
  };
  if (measure == "seats")
    return sum_of([&](const Kind& kind, double width) { return seats_on(vocabulary, kind, width); });
  if (measure == "shelves") return sum_of([&](const Kind& kind, double) { return has_tag(vocabulary, kind, "shelf"); });
  return measure == "occupancy" ? occupancy : static_cast<double>(scene.objects.size());
}

double ErrorReport::missed_in_all() const {
  const auto is_missed = [](const MeasureVerdict& verdict) { return verdict.missed > exact; };
  return violation + static_cast<double>(std::ranges::count_if(measures, is_missed));
}

bool ErrorReport::is_met() const {
  return unmet.empty() && colliding.empty() &&
         std::ranges::all_of(measures, [](const MeasureVerdict& verdict) { return verdict.missed <= exact; });
}

ErrorReport error_report(const Optimisation& result, const Complexity& asked, const ModelTable& models,
                         const KindTable& kinds) {
  ErrorReport report;
  for (const auto& verdict : result.constraints)
    if (!verdict.held) report.unmet.push_back(verdict);
  for (const auto& [name, range] : complexity_measures())
    if (const auto& wanted = asked.*range) {
      const double value = measured(name, result.scene, result.occupancy, kinds);
      report.measures.push_back({name, *wanted, value, missed_by(*wanted, value)});
    }
  for (const auto& violation : examine(result.scene, models, kinds).violations)
    if (violation.fault == Fault::overlap) report.colliding.push_back(violation.object + " and " + violation.other);
  report.things = result.scene.objects.size();
  report.occupancy = result.occupancy;
  report.violation = result.violation;
  for (const auto& object : result.scene.objects) ++report.counts[object.category];
  return report;
}

Json to_json(const ErrorReport& report) {
  Json json;
  json["met"] = report.is_met();
  json["unmet"] = Json::array();
  for (const auto& verdict : report.unmet)
    json["unmet"].push_back({{"name", verdict.name},
                             {"constraint", verdict.text},
                             {"missed", std::round(verdict.amount * 1e6) / 1e6},
                             {"objects", verdict.objects}});
  json["measures"] = Json::array();
  for (const auto& measure : report.measures)
    json["measures"].push_back({{"name", measure.name},
                                {"asked", range_json(measure.asked)},
                                {"reached", std::round(measure.reached * 1e6) / 1e6},
                                {"missed", std::round(measure.missed * 1e6) / 1e6}});
  json["colliding"] = report.colliding;
  if (!report.conflict.empty()) json["conflict"] = report.conflict;
  json["things"] = report.things;
  json["occupancy"] = std::round(report.occupancy * 1e6) / 1e6;
  json["counts"] = report.counts;
  return json;
}

std::string to_text(const ErrorReport& report) {
  std::string text;
  const auto line = [&](const std::string& words) { text += words + "\n"; };
  for (const auto& verdict : report.unmet)
    line("- \"" + verdict.name + "\" is missed by " + format_number(verdict.amount, 2) + ": " + verdict.text +
         (verdict.objects.empty() ? "" : " (" + join(verdict.objects, ", ") + ")"));
  for (const auto& measure : report.measures)
    line("- " + measure.name + ": " + range_text(measure.asked) + " asked for, " + format_number(measure.reached, 2) +
         " reached" + (measure.missed > exact ? ", missed by " + format_number(measure.missed, 2) : ""));
  for (const auto& pair : report.colliding) line("- " + pair + " share space");
  if (!report.conflict.empty())
    line("- as far as short searches tell, " +
         std::string(report.conflict.size() == 1 ? "this room cannot have " : "no room like this has together ") +
         join(report.conflict, ", "));
  std::vector<std::string> counts;
  for (const auto& [kind, count] : report.counts) counts.push_back(std::to_string(count) + " " + kind);
  line("- in the room: " + (counts.empty() ? "nothing" : join(counts, ", ")) + "; " +
       format_number(100.0 * report.occupancy, 1) + " % of the floor is covered");
  return text;
}

}  // namespace roomgen::lab
