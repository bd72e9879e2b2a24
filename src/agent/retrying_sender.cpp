#include "retrying_sender.h"

#include <algorithm>
#include <optional>

#include "dialect.h"
#include "http_status.h"
#include "retry.h"
#include "roomgen/base/text.h"
#include "wire.h"

namespace roomgen {

namespace {

using Seconds = RetryPolicy::Seconds;

bool is_refusal(const HttpOutcome& outcome) {
  const auto* answer = std::get_if<HttpAnswer>(&outcome);
  return answer && refuses_option(answer->status, complaint_in(answer->body));
}

Error given_up(const Error& error, const std::string& why, const Progress& progress) {
  const std::string count =
      progress.requests == 1 ? "1 attempt" : std::to_string(progress.requests) + " attempts";
  return {error.kind, error.message + " (" + why + "gave up after " + count + ", " +
                          format_number(progress.elapsed().count(), 1) + " s)"};
}

}  // namespace

RetryingSender::RetryingSender(Destination destination, const HttpLimits& limits,
                               const RetryPolicy& retry, LogSink log)
    : destination_(std::move(destination)),
      limits_(limits),
      retry_(retry),
      log_(std::move(log)),
      random_(retry.seed) {}

Result<HttpAnswer> RetryingSender::send(const HttpRequest& http, const CancelToken& cancel,
                                        Progress& progress) {
  progress.failures = 0;
  while (true) {
    auto outcome = post(http, cancel, progress);
    if (!is_transient(outcome) || is_refusal(outcome)) return settled(std::move(outcome));

    ++progress.failures;
    const Error error = error_of(outcome);
    const Seconds wait = wait_after(outcome, progress.failures);
    if (auto why = reason_to_stop(outcome, wait, progress)) return given_up(error, *why, progress);
    note(error.message + "; asking again in " + format_number(wait.count(), 1) + " s");
    if (!pause(wait, cancel))
      return Error{Error::Kind::cancelled, destination_.endpoint.shown() + ": cancelled"};
  }
}

// The key is taken out of an answer before anything is quoted from it: a quotation may end in the
// middle of the key.
HttpOutcome RetryingSender::post(const HttpRequest& http, const CancelToken& cancel,
                                 Progress& progress) {
  HttpLimits limits = limits_;
  limits.call = std::min(limits.call, retry_.total - progress.elapsed());
  ++progress.requests;
  auto outcome = transport_.post(http, limits, cancel);
  if (auto* answer = std::get_if<HttpAnswer>(&outcome)) {
    answer->body = destination_.key.scrub(std::move(answer->body));
    answer->location = destination_.key.scrub(std::move(answer->location));
  }
  return outcome;
}

Error RetryingSender::error_of(const HttpOutcome& outcome) const {
  const auto& [endpoint, protocol, key] = destination_;
  Error error = std::holds_alternative<HttpFailure>(outcome)
                    ? failure_error(std::get<HttpFailure>(outcome), endpoint)
                    : status_error(std::get<HttpAnswer>(outcome), endpoint, protocol);
  error.message = key.scrub(std::move(error.message));
  return error;
}

Result<HttpAnswer> RetryingSender::settled(HttpOutcome outcome) const {
  if (std::holds_alternative<HttpFailure>(outcome)) return error_of(outcome);
  return std::get<HttpAnswer>(std::move(outcome));
}

// The server knows best when it will be ready; but not sooner than courtesy asks.
Seconds RetryingSender::wait_after(const HttpOutcome& outcome, int failures) {
  const Seconds own = backoff(retry_, failures, random_);
  const auto* answer = std::get_if<HttpAnswer>(&outcome);
  if (!answer) return own;
  const auto asked = parse_retry_after(answer->retry_after, std::chrono::system_clock::now());
  return asked ? std::max(own, *asked) : own;
}

// Who takes no connection is silent, too, however often it is tried.
std::optional<std::string> RetryingSender::reason_to_stop(const HttpOutcome& outcome, Seconds wait,
                                                          const Progress& progress) const {
  const auto* failure = std::get_if<HttpFailure>(&outcome);
  const bool is_silent = failure && failure->kind == HttpFailure::Kind::not_taken;
  if (is_silent && progress.elapsed() + wait >= limits_.idle) return "silent all the time; ";
  if (progress.failures >= std::max(1, retry_.attempts)) return "";
  if (wait > std::max(retry_.longest_retry_after, retry_.longest_wait))
    return "it asks to wait " + format_number(wait.count(), 0) + " s; ";
  if (progress.elapsed() + wait >= retry_.total) return "out of time; ";
  return std::nullopt;
}

void RetryingSender::note(const std::string& message) const {
  log(log_, LogLevel::info, message);
}

}  // namespace roomgen
