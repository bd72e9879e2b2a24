#include "check_report.h"

#include <nlohmann/json.hpp>

namespace roomgen::cli {

Json check_json(const Scene& scene, const SceneReport& report) {
  Json json;
  json["format"] = "roomgen-scene";
  json["objects"] = scene.objects.size();
  json["unplaced"] = scene.unplaced.size();
  json["constraints"] = report.relations.size();
  json["held"] = report.relations_held();
  json["violations"] = Json::array();
  for (const auto& violation : report.violations)
    json["violations"].push_back(
        {{"fault", name(violation.fault)}, {"object", violation.object}, {"other", violation.other}});
  return json;
}

std::string check_headline(const Scene& scene, const SceneReport& report) {
  return "scene of " + std::to_string(scene.objects.size()) + " objects, " + std::to_string(scene.unplaced.size()) +
         " unplaced; " + std::to_string(report.relations_held()) + " of " + std::to_string(report.relations.size()) +
         " constraints held; " + std::to_string(report.violations.size()) + " faults";
}

std::vector<std::string> check_lines(const SceneReport& report) {
  std::vector<std::string> lines;
  for (const auto& violation : report.violations) lines.push_back("  " + to_text(violation));
  for (const auto& verdict : report.relations)
    if (!verdict.judgement.held) lines.push_back("  not held: " + verdict.object + " | " + to_text(verdict.relation));
  return lines;
}

std::vector<std::string> unmet(const Scene& scene) {
  std::vector<std::string> lines;
  for (const auto& verdict : scene.requirements)
    if (!verdict.met() && verdict.compliance != Compliance::withdrawn)
      lines.push_back(verdict.requirement.clause + ": " + verdict.reason);
  return lines;
}

}  // namespace roomgen::cli
