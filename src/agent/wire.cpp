#include "wire.h"

#include "byte_text.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr std::size_t complaint_bytes = 300;
constexpr std::size_t excerpt_bytes = 80;
constexpr long long max_count = 1'000'000'000'000;

bool is_web_page(std::string_view body) {
  return trim(body).starts_with('<');
}

// {"error": {"message": …}}, {"error": …}, {"message": …} and {"detail": …} are all in use.
std::string message_in(const Json& body) {
  if (!body.is_object()) return {};
  for (const char* key : {"error", "message", "detail"}) {
    const auto found = body.find(key);
    if (found == body.end()) continue;
    if (found->is_string()) return found->get<std::string>();
    if (found->is_object()) return message_in(*found);
  }
  return {};
}

}  // namespace

Result<Json> parse_answer(std::string_view body, const std::string& source) {
  const auto bad = [&](const std::string& what) {
    return Error{Error::Kind::io, source + ": " + what};
  };
  if (trim(body).empty()) return bad("the answer is empty");
  if (is_web_page(body))
    return bad("a web page came instead of an answer; check that the base URL is that of an API");
  if (!is_utf8(body)) return bad("the answer is not valid UTF-8");
  auto json = parse_json(body, source + ": the answer");
  if (json) return json;
  if (json.error().kind == Error::Kind::limit) return json;
  return bad(json.error().message.substr(source.size() + 2) +
             "; it begins: " + excerpt(body, excerpt_bytes));
}

std::string complaint_in(std::string_view body) {
  if (is_web_page(body)) return {};
  const auto json = parse_json(body, "");
  // Gemini wraps its errors into an array.
  const Json* root = json ? &*json : nullptr;
  if (root && root->is_array() && !root->empty()) root = &root->front();
  const std::string message = root ? message_in(*root) : std::string();
  return excerpt(message.empty() ? body : message, complaint_bytes);
}

void AnswerReader::read_usage(const char* input, const char* output, ChatReply& reply) const {
  const auto usage = root["usage"];
  if (!usage.exists()) return;
  reply.input_tokens = usage[input].integer_or(0, 0, max_count);
  reply.output_tokens = usage[output].integer_or(0, 0, max_count);
}

Result<ChatReply> AnswerReader::finish(ChatReply reply, const std::string& source) const {
  if (const auto& problem = problems.first()) return Error{Error::Kind::io, problem->message};
  if (!trim(reply.text).empty()) return reply;
  // Models that think aloud first can spend all of it on that.
  if (reply.cut_off)
    return Error{Error::Kind::io, source + ": the answer was cut off after " +
                                      std::to_string(reply.output_tokens) +
                                      " tokens, before it said anything"};
  return Error{Error::Kind::io, source + ": the model answered with nothing"};
}

Error refused(const std::string& source, std::string_view why) {
  return {Error::Kind::io, source + ": the model declined to answer" +
                               (why.empty() ? "" : ": " + excerpt(why, complaint_bytes))};
}

std::string media_type(std::string_view image) {
  if (image.substr(0, 12).find("ftyp") == 4) return "video/mp4";
  return image.starts_with("\xFF\xD8") ? "image/jpeg" : "image/png";
}

}  // namespace roomgen
