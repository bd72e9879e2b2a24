#include "roomgen/agent/http_model.h"

#include <algorithm>

#include "anthropic_wire.h"
#include "api_key.h"
#include "dialect.h"
#include "endpoint.h"
#include "http_status.h"
#include "openai_wire.h"
#include "retry.h"
#include "roomgen/base/text.h"
#include "transport.h"

namespace roomgen {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = RetryPolicy::Seconds;

// One question on its way: what it has cost so far.
struct Progress {
  Clock::time_point start = Clock::now();
  int requests = 0;
  int failures = 0;

  Seconds elapsed() const { return Clock::now() - start; }
};

class HttpModel final : public ChatModel {
 public:
  HttpModel(HttpModelOptions options, ChatProtocol protocol, Endpoint endpoint, ApiKey key)
      : options_(std::move(options)),
        protocol_(protocol),
        endpoint_(std::move(endpoint)),
        key_(std::move(key)),
        random_(options_.retry.seed) {
    dialect_.token_limit_settled = protocol == ChatProtocol::anthropic;
    if (endpoint_.host.ends_with("openai.com"))
      dialect_.token_limit = Dialect::TokenLimit::max_completion_tokens;
  }

  Result<ChatReply> chat(const ChatRequest& request) override {
    auto reply = converse(request);
    if (!reply) return Error{reply.error().kind, key_.scrub(reply.error().message)};
    reply->text = key_.scrub(std::move(reply->text));
    reply->model = key_.scrub(std::move(reply->model));
    return reply;
  }

 private:
  // Asks, with fewer options each time the endpoint refuses one; what it took is remembered.
  Result<ChatReply> converse(const ChatRequest& request) {
    Progress progress;
    Dialect dialect = dialect_;
    while (true) {
      const auto answer = ask(http_request(request, dialect), request.cancel, progress);
      if (!answer) return answer.error();
      if (answer->status >= 200 && answer->status < 300) {
        dialect_ = dialect;
        return read(*answer, progress);
      }
      const auto next = answer->status == 400 || answer->status == 422
                            ? concede(dialect, request, complaint_in(answer->body))
                            : std::nullopt;
      if (!next) return status_error(*answer, endpoint_, protocol_);
      note(endpoint_.shown() + ": refused an option; asking again without it");
      dialect = *next;
    }
  }

  HttpRequest http_request(const ChatRequest& request, const Dialect& dialect) const {
    HttpRequest http;
    http.url = endpoint_.url();
    http.direct = endpoint_.is_loopback();
    http.headers = {{"Content-Type", "application/json"}, {"Accept", "application/json"}};
    const bool anthropic = protocol_ == ChatProtocol::anthropic;
    if (anthropic) http.headers.emplace_back("anthropic-version", "2023-06-01");
    if (!key_.empty() && anthropic) http.headers.emplace_back("x-api-key", key_.reveal());
    if (!key_.empty() && !anthropic)
      http.headers.emplace_back("Authorization", "Bearer " + key_.reveal());
    const Json body = anthropic ? anthropic_body(request, options_.model, dialect)
                                : openai_body(request, options_.model, dialect);
    http.body = body.dump(-1, ' ', false, Json::error_handler_t::replace);
    return http;
  }

  // Sends until there is an answer that waiting would not change.
  Result<HttpAnswer> ask(const HttpRequest& http, const CancelToken& cancel, Progress& progress) {
    progress.failures = 0;
    while (true) {
      HttpLimits limits = options_.limits;
      limits.call = std::min(limits.call, options_.retry.total - progress.elapsed());
      ++progress.requests;
      auto outcome = scrubbed(transport_.post(http, limits, cancel));
      if (!is_transient(outcome)) return settled(std::move(outcome));

      ++progress.failures;
      const Error error = error_of(outcome);
      const Seconds wait = wait_after(outcome, progress.failures);
      if (auto why = reason_to_stop(wait, progress)) return given_up(error, *why, progress);
      note(error.message + "; asking again in " + format_number(wait.count(), 1) + " s");
      if (!pause(wait, cancel))
        return Error{Error::Kind::cancelled, endpoint_.shown() + ": cancelled"};
    }
  }

  // Before anything is quoted from the answer: a quotation may end in the middle of the key.
  HttpOutcome scrubbed(HttpOutcome outcome) const {
    if (auto* answer = std::get_if<HttpAnswer>(&outcome)) {
      answer->body = key_.scrub(std::move(answer->body));
      answer->location = key_.scrub(std::move(answer->location));
    }
    return outcome;
  }

  Result<HttpAnswer> settled(HttpOutcome outcome) const {
    if (const auto* failure = std::get_if<HttpFailure>(&outcome))
      return failure_error(*failure, endpoint_);
    return std::get<HttpAnswer>(std::move(outcome));
  }

  Error error_of(const HttpOutcome& outcome) const {
    if (const auto* failure = std::get_if<HttpFailure>(&outcome))
      return failure_error(*failure, endpoint_);
    return status_error(std::get<HttpAnswer>(outcome), endpoint_, protocol_);
  }

  // The server knows best when it will be ready; but not sooner than courtesy asks.
  Seconds wait_after(const HttpOutcome& outcome, int failures) {
    const Seconds own = backoff(options_.retry, failures, random_);
    const auto* answer = std::get_if<HttpAnswer>(&outcome);
    if (!answer) return own;
    const auto asked = parse_retry_after(answer->retry_after, std::chrono::system_clock::now());
    return asked ? std::max(own, *asked) : own;
  }

  std::optional<std::string> reason_to_stop(Seconds wait, const Progress& progress) const {
    const RetryPolicy& retry = options_.retry;
    if (progress.failures >= std::max(1, retry.attempts)) return "";
    if (wait > std::max(retry.longest_retry_after, retry.longest_wait))
      return "it asks to wait " + format_number(wait.count(), 0) + " s; ";
    if (progress.elapsed() + wait >= retry.total) return "out of time; ";
    return std::nullopt;
  }

  static Error given_up(const Error& error, const std::string& why, const Progress& progress) {
    const std::string count =
        progress.requests == 1 ? "1 attempt" : std::to_string(progress.requests) + " attempts";
    return {error.kind, error.message + " (" + why + "gave up after " + count + ", " +
                            format_number(progress.elapsed().count(), 1) + " s)"};
  }

  Result<ChatReply> read(const HttpAnswer& answer, const Progress& progress) const {
    const std::string source = endpoint_.shown();
    const auto json = parse_answer(answer.body, source);
    if (!json) return json.error();
    auto reply = protocol_ == ChatProtocol::anthropic ? read_anthropic_reply(*json, source)
                                                      : read_openai_reply(*json, source);
    if (!reply) return reply;
    if (reply->model.empty()) reply->model = options_.model;
    reply->attempts = progress.requests;
    reply->seconds = progress.elapsed().count();
    return reply;
  }

  void note(const std::string& message) const {
    log(options_.log, LogLevel::info, key_.scrub(message));
  }

  HttpModelOptions options_;
  ChatProtocol protocol_;
  Endpoint endpoint_;
  ApiKey key_;
  Dialect dialect_;
  Random random_;
  Transport transport_;
};

}  // namespace

Result<std::unique_ptr<ChatModel>> make_http_model(const HttpModelOptions& options) {
  if (trim(options.model).empty())
    return Error{Error::Kind::invalid_input, "which model? Give the name the endpoint knows it by"};
  const auto base = parse_base_url(options.base_url);
  if (!base) return base.error();
  const ChatProtocol protocol = options.protocol.value_or(protocol_of(*base));
  auto endpoint = chat_endpoint(*base, protocol);
  auto key = read_api_key(protocol, endpoint, options.key_file);
  if (!key) return key.error();
  return std::unique_ptr<ChatModel>(
      std::make_unique<HttpModel>(options, protocol, std::move(endpoint), std::move(*key)));
}

}  // namespace roomgen
