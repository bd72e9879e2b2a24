#pragma once

#include <chrono>
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
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  int requests = 0;
  int failures = 0;  ///< in a row

  RetryPolicy::Seconds elapsed() const { return std::chrono::steady_clock::now() - start; }
};

/// Sends a request as often as makes sense. Nothing that comes out of it holds the key.
class RetryingSender {
 public:
  RetryingSender(Destination destination, const HttpLimits& limits, const RetryPolicy& retry,
                 LogSink log);

  const Destination& destination() const { return destination_; }

  /// An answer that waiting would not change, whatever its status, or why there is none.
  Result<HttpAnswer> send(const HttpRequest& http, const CancelToken& cancel, Progress& progress);

 private:
  HttpOutcome post(const HttpRequest& http, const CancelToken& cancel, Progress& progress);
  Result<HttpAnswer> settled(HttpOutcome outcome) const;
  Error error_of(const HttpOutcome& outcome) const;
  RetryPolicy::Seconds wait_after(const HttpOutcome& outcome, int failures);
  std::optional<std::string> reason_to_stop(const HttpOutcome& outcome, RetryPolicy::Seconds wait,
                                            const Progress& progress) const;
  void note(const std::string& message) const;

  Destination destination_;
  HttpLimits limits_;
  RetryPolicy retry_;
  LogSink log_;
  Random random_;
  Transport transport_;
};

}  // namespace roomgen
