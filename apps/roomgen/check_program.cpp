#include "check_program.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "roomgen/base/text.h"
#include "roomgen/program/program.h"

namespace roomgen::cli {

namespace {

using Findings = std::vector<ProgramFinding>;

bool is_error(const ProgramFinding& finding) { return finding.severity == ProgramFinding::Severity::error; }

std::string severity(const ProgramFinding& finding) { return is_error(finding) ? "error" : "warning"; }

std::string counted(std::size_t number, const std::string& noun) {
  return std::to_string(number) + " " + noun + (number == 1 ? "" : "s");
}

std::string program_headline(const ConstraintProgram& program, std::size_t errors) {
  return (errors == 0 ? "sound program of " : counted(errors, "error") + " in the program of ") +
         counted(program.sets.size(), "set") + ", " + counted(program.constraints.size(), "constraint") + " and " +
         counted(program.scores.size(), "score");
}

Json findings_json(const Findings& findings) {
  Json json = Json::array();
  for (const auto& finding : findings)
    json.push_back({{"severity", severity(finding)}, {"at", finding.at}, {"message", finding.message}});
  return json;
}

void print_program(const std::string& file, const ConstraintProgram& program, const Findings& findings,
                   std::size_t errors) {
  std::printf("%s: %s\n", printable(file).c_str(), printable(program_headline(program, errors)).c_str());
  for (const auto& finding : findings)
    std::printf("  %s: %s: %s\n", severity(finding).c_str(), printable(finding.at).c_str(), printable(finding.message).c_str());
  std::fputs(printable(to_text(program)).c_str(), stdout);
}

}  // namespace

Result<int> check_program(const Context& context, const std::string& file, const Json& json) {
  const auto program = program_from_json(json, file);
  if (!program) return program.error();
  const Findings findings = check(*program, KindTable::built_in());
  const auto errors = static_cast<std::size_t>(std::count_if(findings.begin(), findings.end(), is_error));
  if (context.json) {
    const Json summary = {{"format", "roomgen-program"}, {"file", file}, {"errors", errors},
                          {"findings", findings_json(findings)}, {"text", to_text(*program)}};
    std::fputs(dump_json(summary).c_str(), stdout);
  } else {
    print_program(file, *program, findings, errors);
  }
  return errors == 0 ? exit_ok : exit_failure;
}

}  // namespace roomgen::cli
