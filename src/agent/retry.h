#pragma once

#include <chrono>
#include <optional>
#include <string_view>

#include "base/random.h"
#include "roomgen/agent/http_model.h"
#include "transport.h"

namespace roomgen {

/// Whether the same request may succeed a little later.
bool is_transient(const HttpOutcome& outcome);

/// The wait that a Retry-After header asks for: seconds, or an HTTP date (RFC 9110, IMF-fixdate);
/// zero for a date in the past, nothing for other texts.
std::optional<RetryPolicy::Seconds> parse_retry_after(std::string_view text,
                                                      std::chrono::system_clock::time_point now);

/// The wait after the `failures`-th failure in a row, counted from 1.
RetryPolicy::Seconds backoff(const RetryPolicy& policy, int failures, Random& random);

/// Whether a server says that it is still loading its model: only time tells when it is ready.
bool is_loading(const HttpOutcome& outcome);

}  // namespace roomgen
