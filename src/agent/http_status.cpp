#include "http_status.h"

#include "byte_text.h"
#include "wire.h"

namespace roomgen {

namespace {

// The host that a redirect names; a path alone stays on the same one.
std::string redirect_target(const HttpAnswer& answer, const Endpoint& endpoint) {
  if (answer.location.empty()) return "nowhere";
  const auto target = parse_base_url(answer.location);
  return excerpt(target ? target->authority() : endpoint.authority(), 100);
}

std::string key_advice(ChatProtocol protocol) {
  const char* variable =
      protocol == ChatProtocol::anthropic ? "ANTHROPIC_API_KEY" : "OPENAI_API_KEY";
  return std::string("set ") + variable + " (or ROOMGEN_API_KEY, or the key file) to a valid key";
}

std::string advice(int status, ChatProtocol protocol) {
  if (status == 401 || status == 403) return key_advice(protocol);
  if (status == 402) return "the account needs credit";
  if (status == 404 || status == 405) return "check the model's name and the base URL";
  if (status == 413) return "the question is too large for this endpoint: use smaller pictures";
  if (status == 429) return "the endpoint limits how often and how much it is asked: try later";
  if (status >= 500) return "the server failed: try later";
  return "the endpoint does not take this question";
}

Error::Kind kind_of(int status, bool quota_used_up) {
  if (status == 413) return Error::Kind::limit;
  const bool useless = (status >= 401 && status <= 405) || (status == 429 && quota_used_up);
  return useless ? Error::Kind::unavailable : Error::Kind::io;
}

}  // namespace

Error status_error(const HttpAnswer& answer, const Endpoint& endpoint, ChatProtocol protocol) {
  if (answer.status >= 300 && answer.status < 400)
    return {Error::Kind::unavailable,
            endpoint.shown() + ": answered " + std::to_string(answer.status) + ", a redirect to " +
                redirect_target(answer, endpoint) +
                ", which is not followed; if it is right, name it in the base URL"};
  const std::string complaint = complaint_in(answer.body);
  const bool quota = answer.body.find("insufficient_quota") != std::string::npos;
  return {kind_of(answer.status, quota), endpoint.shown() + ": answered " +
                                             std::to_string(answer.status) +
                                             (complaint.empty() ? "" : " (" + complaint + ")") +
                                             "; " + advice(answer.status, protocol)};
}

Error failure_error(const HttpFailure& failure, const Endpoint& endpoint) {
  using Kind = HttpFailure::Kind;
  const std::string at = endpoint.shown() + ": ";
  const std::string detail = failure.what.empty() ? "" : " (" + excerpt(failure.what, 200) + ")";
  switch (failure.kind) {
    case Kind::no_such_host:
      return {Error::Kind::unavailable, at + "no such host" + detail + "; check the base URL"};
    case Kind::refused:
      return {Error::Kind::unavailable,
              at + "cannot connect" + detail + "; check the base URL and that the server runs"};
    case Kind::tls:
      return {Error::Kind::unavailable,
              at + "no trusted TLS connection" + detail + "; check the server's certificate"};
    case Kind::not_taken:
      return {Error::Kind::limit, at + "takes no connection" + detail + "; check the base URL, or try later"};
    case Kind::timed_out:
      return {Error::Kind::limit,
              at + "too slow" + detail + "; allow more time (--call-seconds), or try later"};
    case Kind::silent:
      return {Error::Kind::limit,
              at + "silent" + detail +
                  "; a model that is slower, or thinks longer, needs more time (--idle-seconds)"};
    case Kind::too_long:
      return {Error::Kind::limit, at + failure.what + "; this is hardly a model's answer"};
    case Kind::cancelled:
      return {Error::Kind::cancelled, at + "cancelled"};
    case Kind::broken:
      break;
  }
  return {Error::Kind::io, at + "the connection broke" + detail + "; try again"};
}

}  // namespace roomgen
