#include "chat_recording.h"

#include <array>
#include <utility>

#include "base/json_reader.h"
#include "chat_question.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr std::size_t max_message = 64u << 10;

constexpr std::array<std::pair<Error::Kind, const char*>, 6> kind_names = {
    {{Error::Kind::invalid_input, "invalid_input"},
     {Error::Kind::not_found, "not_found"},
     {Error::Kind::io, "io"},
     {Error::Kind::limit, "limit"},
     {Error::Kind::cancelled, "cancelled"},
     {Error::Kind::unavailable, "unavailable"}}};

const char* kind_name(Error::Kind kind) {
  for (const auto& [candidate, name] : kind_names)
    if (candidate == kind) return name;
  return "io";
}

Error read_error(const JsonReader& json) {
  const std::string wanted = json["kind"].text();
  Error error{Error::Kind::io, json["message"].text(max_message)};
  bool known = false;
  for (const auto& [kind, name] : kind_names)
    if (wanted == name) error.kind = kind, known = true;
  if (!known) json["kind"].report("unknown kind of error");
  return error;
}

Result<RecordedAnswer> parse_line(std::string_view text, int number, const std::string& source) {
  const std::string where = source + ": line " + std::to_string(number);
  const auto json = parse_json(text, where);
  if (!json) return json.error();
  JsonReader::Problems problems(where);
  const JsonReader root(*json, problems);
  RecordedAnswer recorded;
  recorded.line = number;
  recorded.key = root["key"].text();
  if (!root["request"].is_object())
    root.report("no \"request\"");
  else
    recorded.question = *root["request"].raw();
  if (root["error"].exists())
    recorded.answer = read_error(root["error"]);
  else
    recorded.answer = read_reply(root["reply"]);
  if (auto error = problems.first()) return *error;
  return recorded;
}

}  // namespace

std::string recorded_line(const ChatRequest& request, const Result<ChatReply>& answer) {
  const Json question = question_json(request);
  Json line = {{"key", question_key(question)}, {"request", question}};
  if (answer)
    line["reply"] = reply_json(*answer);
  else
    line["error"] = {{"kind", kind_name(answer.error().kind)}, {"message", answer.error().message}};
  return json_line(line) + "\n";
}

Result<std::vector<RecordedAnswer>> parse_recording(std::string_view text,
                                                    const std::string& source) {
  std::vector<RecordedAnswer> answers;
  for (int number = 1; !text.empty(); ++number) {
    const auto end = text.find('\n');
    const auto line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (trim(line).empty()) continue;
    auto answer = parse_line(line, number, source);
    if (!answer) return answer.error();
    answers.push_back(*std::move(answer));
  }
  return answers;
}

}  // namespace roomgen
