#include "check_report.h"

#include <nlohmann/json.hpp>

namespace roomgen::cli {

namespace {

std::vector<std::string> not_held(const SceneReport& report) {
  std::vector<std::string> texts;
  for (const auto& verdict : report.relations)
    if (!verdict.judgement.held)
      texts.push_back(verdict.object + " | " + to_text(verdict.relation));
  return texts;
}

}  // namespace

Json check_json(const Scene& scene, const SceneReport& report) {
  Json json;
  json["format"] = "roomgen-scene";
  json["valid"] = report.violations.empty();
  json["objects"] = scene.objects.size();
  json["unplaced"] = scene.unplaced.size();
  json["constraints"] = report.relations.size();
  json["held"] = report.relations_held();
  json["not_held"] = not_held(report);
  const Clauses clauses = clauses_of(scene);
  json["asked"] = clauses.asked;
  json["met"] = clauses.met;
  json["not_met"] = clauses.unmet;
  json["violations"] = Json::array();
  for (const auto& violation : report.violations)
    json["violations"].push_back(
        {{"fault", name(violation.fault)}, {"object", violation.object}, {"other", violation.other}});
  return json;
}

std::string check_headline(const Scene& scene, const SceneReport& report) {
  const auto of = [](auto part, std::size_t all) {
    return std::to_string(part) + " of " + std::to_string(all);
  };
  const Clauses clauses = clauses_of(scene);
  return "scene of " + std::to_string(scene.objects.size()) + " objects, " +
         std::to_string(scene.unplaced.size()) + " unplaced; " +
         of(report.relations_held(), report.relations.size()) + " constraints held; " +
         (clauses.asked > 0 ? of(clauses.met, clauses.asked) + " clauses met; " : "") +
         std::to_string(report.violations.size()) + " faults";
}

std::vector<std::string> check_lines(const Scene& scene, const SceneReport& report) {
  std::vector<std::string> lines;
  for (const auto& violation : report.violations) lines.push_back("  " + to_text(violation));
  for (const auto& text : not_held(report)) lines.push_back("  not held: " + text);
  for (const auto& clause : clauses_of(scene).unmet) lines.push_back("  not met: " + clause);
  return lines;
}

Clauses clauses_of(const Scene& scene) {
  Clauses clauses;
  for (const auto& verdict : scene.requirements) {
    if (verdict.compliance == Compliance::withdrawn) continue;
    ++clauses.asked;
    if (verdict.met()) ++clauses.met;
    else clauses.unmet.push_back(told(verdict.requirement) + ": " + verdict.reason);
  }
  return clauses;
}

}  // namespace roomgen::cli
