#pragma once

#include <optional>
#include <string>

#include "api_key.h"
#include "base/random.h"
#include "endpoint.h"
#include "roomgen/agent/http_model.h"
#include "transport.h"

namespace roomgen {

/// Who is asked, in which language, and known by which key.
struct Destination {
  Endpoint endpoint;
  ChatProtocol protocol = ChatProtocol::openai;
  ApiKey key;
};

/// One question on its way: what it has cost so far.
struct Progress {
  const ChatRequest& question;
  HttpClock::Seconds start;
  int requests = 0;
  int failures = 0;  ///< in a row
};

/// Sends a request as often as makes sense. Nothing that comes out of it holds the key.
class RetryingSender {
 public:
  RetryingSender(Destination destination, const HttpLimits& limits, const RetryPolicy& retry,
                 HttpClock clock, LogSink log);

  const Destination& destination() const { return destination_; }

  Progress begin(const ChatRequest& question) const { return {question, clock_.now()}; }
  RetryPolicy::Seconds elapsed(const Progress& progress) const {
    return clock_.now() - progress.start;
  }
  /// An answer that waiting would not change, whatever its status, or why there is none. Each
  /// request asks the question's meter first, and is counted there.
  Result<HttpAnswer> send(const HttpRequest& http, Progress& progress);

 private:
  HttpOutcome post(const HttpRequest& http, Progress& progress);
  Result<HttpAnswer> settled(HttpOutcome outcome) const;
  Error error_of(const HttpOutcome& outcome) const;
  Error given_up(const Error& error, const std::string& why, const Progress& progress) const;
  RetryPolicy::Seconds wait_after(const HttpOutcome& outcome, int failures);
  std::optional<std::string> reason_to_stop(const HttpOutcome& outcome, RetryPolicy::Seconds wait,
                                            const Progress& progress) const;
  void note(const std::string& message) const;

  Destination destination_;
  HttpLimits limits_;
  RetryPolicy retry_;
  LogSink log_;
  HttpClock clock_;
  Random random_;
  Transport transport_;
};

}  // namespace roomgen
