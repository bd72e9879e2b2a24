#include "answer_form.h"

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "base/json_values.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

const Json& first_choice(const Json& answer) {
  const Json& choices = member_of(answer, "choices");
  return choices.is_array() && !choices.empty() ? choices.front() : member_of(choices, "");
}

bool is_comment(std::string_view line) {
  return trim(line).empty() || line.front() == ':';
}

// The line at the beginning of a text, which it is taken from.
std::string_view take_line(std::string_view& text) {
  const auto end = text.find('\n');
  const auto line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

std::string_view without_comments_ahead(std::string_view body) {
  for (std::string_view rest = body; !rest.empty(); body = rest)
    if (!is_comment(take_line(rest))) break;
  return body;
}

bool is_event_stream(std::string_view body) {
  return body.starts_with("data:") || body.starts_with("event:") || body.starts_with("id:");
}

// What the events hold, up to the end of the stream; nothing if one of them is no JSON.
std::optional<std::vector<Json>> events_of(std::string_view stream) {
  constexpr std::string_view field = "data:";
  std::vector<Json> events;
  while (!stream.empty()) {
    const auto line = take_line(stream);
    if (!line.starts_with(field)) continue;
    const auto data = trim(line.substr(field.size()));
    if (data == "[DONE]") break;
    auto event = parse_json(data, "");
    if (!event) return std::nullopt;
    events.push_back(*std::move(event));
  }
  return events;
}

void append_text(const Json& delta, const char* key, Json& message) {
  const Json& piece = member_of(delta, key);
  if (!piece.is_string()) return;
  message[key] = message.value(key, std::string()) + piece.get<std::string>();
}

// One completion of the pieces of an answer.
Json completion_of(const std::vector<Json>& events) {
  Json message = {{"role", "assistant"}}, choice = {{"finish_reason", nullptr}}, completion;
  for (const auto& event : events) {
    const Json& piece = first_choice(event);
    for (const char* key : {"content", "reasoning_content", "reasoning", "refusal"})
      append_text(member_of(piece, "delta"), key, message);
    if (const Json& reason = member_of(piece, "finish_reason"); !reason.is_null())
      choice["finish_reason"] = reason;
    for (const char* key : {"model", "usage"})
      if (const Json& value = member_of(event, key); !value.is_null()) completion[key] = value;
  }
  choice["message"] = std::move(message);
  completion["choices"] = Json::array({std::move(choice)});
  return completion;
}

// An error, or a whole answer, that came as an event.
bool stands_alone(const Json& event) {
  return !member_of(event, "error").is_null() ||
         !member_of(first_choice(event), "message").is_null();
}

std::optional<long long> count_in(const Json& usage, std::initializer_list<const char*> names) {
  for (const char* key : names)
    if (const Json& count = member_of(usage, key); count.is_number_integer() && count >= 0)
      return count.get<long long>();
  return std::nullopt;
}

}  // namespace

std::string plain_json(std::string_view body) {
  body = without_comments_ahead(body);
  if (!is_event_stream(body)) return std::string(body);
  const auto events = events_of(body);
  if (!events || events->empty()) return std::string(body);
  for (const auto& event : *events)
    if (stands_alone(event)) return json_line(event);
  return json_line(completion_of(*events));
}

HttpAnswer as_meant(HttpAnswer answer) {
  if (answer.status < 200 || answer.status >= 300) return answer;
  answer.body = plain_json(answer.body);
  const auto json = parse_json(answer.body, "");
  if (!json) return answer;
  const Json& code = member_of(member_of(*json, "error"), "code");
  if (code.is_number_integer() && code >= 400 && code < 600) answer.status = code.get<int>();
  return answer;
}

ChatUse use_of(const HttpAnswer& answer) {
  ChatUse use;
  const auto json = parse_json(answer.body, "");
  const Json& usage = json ? member_of(*json, "usage") : member_of({}, "");
  use.input_tokens = count_in(usage, {"prompt_tokens", "input_tokens"});
  use.output_tokens = count_in(usage, {"completion_tokens", "output_tokens"});
  if (use.input_tokens || use.output_tokens) {
    use.input_tokens = use.input_tokens.value_or(0);
    use.output_tokens = use.output_tokens.value_or(0);
    return use;
  }
  const bool failed = answer.status < 200 || answer.status >= 300 ||
                      (json && !member_of(*json, "error").is_null());
  if (failed)
    use.input_tokens = use.output_tokens = 0;
  else
    use.answer_bytes = answer.body.size();
  return use;
}

}  // namespace roomgen
