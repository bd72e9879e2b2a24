#include "retrying_sender.h"

#include <algorithm>

#include "answer_form.h"
#include "dialect.h"
#include "http_status.h"
#include "retry.h"
#include "roomgen/base/text.h"
#include "wire.h"

namespace roomgen {

namespace {

using Seconds = RetryPolicy::Seconds;

bool is_refusal(const HttpOutcome& outcome, const ChatRequest& question) {
  const auto* answer = std::get_if<HttpAnswer>(&outcome);
  if (!answer) return false;
  const std::string complaint = complaint_in(answer->body);
  return refuses_option(answer->status, complaint) ||
         refuses_pictures(answer->status, question, complaint);
}

// What never reached the server cost nothing.
void count(const HttpOutcome& outcome, Seconds seconds, const ChatMeter& meter) {
  const auto* failure = std::get_if<HttpFailure>(&outcome);
  if (!meter.count || (failure && !failure->sent)) return;
  ChatUse use = failure ? ChatUse() : use_of(std::get<HttpAnswer>(outcome));
  use.seconds = seconds.count();
  meter.count(use);
}

}  // namespace

RetryingSender::RetryingSender(Destination destination, const HttpLimits& limits,
                               const RetryPolicy& retry, HttpClock clock, LogSink log)
    : destination_(std::move(destination)),
      limits_(limits),
      retry_(retry),
      log_(std::move(log)),
      clock_(std::move(clock)),
      random_(retry.seed),
      transport_(clock_) {}

Result<HttpAnswer> RetryingSender::send(const HttpRequest& http, Progress& progress) {
  const ChatRequest& question = progress.question;
  progress.failures = 0;
  while (true) {
    if (question.meter.admit)
      if (auto status = question.meter.admit(); !status) return status.error();
    auto outcome = post(http, progress);
    if (!is_transient(outcome) || is_refusal(outcome, question)) return settled(std::move(outcome));

    ++progress.failures;
    const Error error = error_of(outcome);
    const Seconds wait = wait_after(outcome, progress.failures);
    if (auto why = reason_to_stop(outcome, wait, progress)) return given_up(error, *why, progress);
    note(error.message + "; asking again in " + format_number(wait.count(), 1) + " s");
    if (!clock_.pause(wait, question.cancel))
      return Error{Error::Kind::cancelled, destination_.endpoint.shown() + ": cancelled"};
  }
}

// The key is taken out of an answer before anything is quoted from it: a quotation may end in the
// middle of the key.
HttpOutcome RetryingSender::post(const HttpRequest& http, Progress& progress) {
  HttpLimits limits = limits_;
  limits.call = std::min(limits.call, retry_.total - elapsed(progress));
  ++progress.requests;
  const Seconds start = clock_.now();
  auto outcome = transport_.post(http, limits, progress.question.cancel);
  if (auto* answer = std::get_if<HttpAnswer>(&outcome)) *answer = as_meant(std::move(*answer));
  count(outcome, clock_.now() - start, progress.question.meter);
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

Error RetryingSender::given_up(const Error& error, const std::string& why,
                               const Progress& progress) const {
  const std::string count =
      progress.requests == 1 ? "1 attempt" : std::to_string(progress.requests) + " attempts";
  return {error.kind, error.message + " (" + why + "gave up after " + count + ", " +
                          format_number(elapsed(progress).count(), 1) + " s)"};
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
  if (is_silent && elapsed(progress) + wait >= limits_.idle) return "silent all the time; ";
  if (progress.failures >= std::max(1, retry_.attempts) && !is_loading(outcome)) return "";
  if (wait > std::max(retry_.longest_retry_after, retry_.longest_wait))
    return "it asks to wait " + format_number(wait.count(), 0) + " s; ";
  if (elapsed(progress) + wait >= retry_.total) return "out of time; ";
  return std::nullopt;
}

void RetryingSender::note(const std::string& message) const {
  log(log_, LogLevel::info, message);
}

}  // namespace roomgen
