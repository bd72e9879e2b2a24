#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "add_commands.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/lab/program.h"

namespace roomgen::cli {

using namespace lab;

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

Result<int> run(const Context& context, const std::string& file) {
  const auto program = read_program(file);
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

}  // namespace

void add_check_command(CLI::App& app, Context& context) {
  auto file = std::make_shared<std::string>();
  auto* sub = app.add_subcommand("check", "Check a constraint program; exit 1 if it has errors");
  sub->add_option("file", *file, "program.json")->required();
  sub->callback(
      [file, &context] { context.run = [file, &context] { return run(context, *file); }; });
}

}  // namespace roomgen::cli
