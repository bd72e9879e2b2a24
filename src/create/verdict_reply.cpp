#include <algorithm>
#include <nlohmann/json.hpp>

#include "chat/loose_json.h"
#include "maker_replies.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen::create {

namespace {

constexpr std::size_t most_reason = 300;  // bytes

std::optional<bool> yes_or_no(const Json& value) {
  if (value.is_boolean()) return value.get<bool>();
  if (!value.is_string()) return std::nullopt;
  const auto said = words(value.get_ref<const std::string&>());
  const auto says = [&](std::initializer_list<const char*> any) {
    return std::any_of(any.begin(), any.end(), [&](const char* word) {
      return std::find(said.begin(), said.end(), word) != said.end();
    });
  };
  // "does not pass" holds both.
  if (says({"not", "no", "false", "fails", "fail", "rejected"})) return false;
  if (says({"pass", "passes", "yes", "true", "accepted"})) return true;
  return std::nullopt;
}

}  // namespace

Result<Reading<Verdict>> read_verdict_reply(const std::string& text) {
  auto loose = find_json(
      text, {{"passes", "reason"}, {"pass", "verdict", "classification", "result"}});
  if (!loose) return loose.error();
  const Json* passes = member(
      loose->json, {"passes", "pass", "verdict", "classification", "result", "is furniture"});
  const auto answer = passes ? yes_or_no(*passes) : std::nullopt;
  if (!answer) return Error{Error::Kind::invalid_input, "\"passes\" must be true or false"};
  Reading<Verdict> reading;
  reading.repairs = std::move(loose->repairs);
  reading.value.passes = *answer;
  const Json* reason = member(loose->json, {"reason", "explanation", "why", "reasoning"});
  if (reason && reason->is_string())
    reading.value.reason =
        shortened(std::string(trim(reason->get_ref<const std::string&>())), most_reason);
  return reading;
}

}  // namespace roomgen::create
