#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "chat/loose_json.h"
#include "model_author.h"
#include "roomgen/base/text.h"

namespace roomgen::lab::compose {

namespace {

constexpr std::size_t most_findings = 8;

// The patched program. What a patch is about may be missing.
Result<Json> patched(const Json& before, const Json& patch) {
  try {
    return before.patch(patch);
  } catch (const Json::exception& fault) {
    return Error{Error::Kind::invalid_input, std::string("the patch does not apply to the program: ") + fault.what()};
  }
}

// A model that was asked for a patch often answers with the operations alone, as RFC 6902 has them.
std::optional<Json> bare_patch(const std::string& text) {
  const auto first = text.find('['), last = text.rfind(']');
  if (first == std::string::npos || last == std::string::npos || last < first || text.find('{') < first ||
      text.size() > max_reply_bytes)
    return std::nullopt;
  auto json = parse_json(text.substr(first, last - first + 1), "patch");
  const auto is_operation = [](const Json& one) { return one.is_object() && one.contains("op") && one.contains("path"); };
  if (!json || !json->is_array() || json->empty() || !std::ranges::all_of(*json, is_operation)) return std::nullopt;
  return *std::move(json);
}

Result<Json> program_json_of(const Json& answer, const Json& before) {
  if (const Json* program = member(answer, {"program"}); program && program->is_object()) return *program;
  if (const Json* patch = member(answer, {"patch", "operations"}); patch && patch->is_array()) {
    if (before.is_null())
      return Error{Error::Kind::invalid_input, "a patch needs a program before it; answer with a whole \"program\""};
    return patched(before, *patch);
  }
  if (answer.contains("constraints") && answer.contains("sets")) return answer;
  return Error{Error::Kind::invalid_input, "it holds no \"program\" and no \"patch\""};
}

Status check_for_model(const ConstraintProgram& program, const KindTable& kinds) {
  std::vector<std::string> faults;
  for (const auto& finding : check(program, kinds))
    if (finding.severity == ProgramFinding::Severity::error && faults.size() < most_findings)
      faults.push_back(finding.at + ": " + finding.message);
  if (faults.empty()) return {};
  return Error{Error::Kind::invalid_input, "the program is wrong at " + join(faults, "; ")};
}

}  // namespace

Result<ProgramAnswer> read_program_answer(const std::string& text, const Json& before, const KindTable& kinds) {
  Result<LooseJson> found = Error{};
  if (auto operations = bare_patch(text))
    found = LooseJson{Json{{"patch", *std::move(operations)}}, {"the operations stood alone, not under \"patch\""}};
  else
    found = find_json(text, {{"program", "patch", "constraints"}, {"reasoning", "sets", "operations"}});
  if (!found) return found.error();
  const auto json = program_json_of(found->json, before);
  if (!json) return json.error();
  auto program = program_from_json(*json, "program");
  if (!program) return program.error();
  if (auto sound = check_for_model(*program, kinds); !sound) return sound.error();
  ProgramAnswer answer{*std::move(program), {}, found->repairs};
  if (const Json* why = member(found->json, {"reasoning", "thoughts"}); why && why->is_string())
    answer.reasoning = why->get<std::string>();
  return answer;
}

}  // namespace roomgen::lab::compose
