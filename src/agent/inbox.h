#pragma once

#include <chrono>
#include <cstddef>
#include <string_view>
#include <utility>

#include "transport.h"

namespace roomgen {

/// What arrives of an answer, within its bounds. Headers and bytes that go beyond them are refused.
class Inbox {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Inbox(const HttpLimits& limits) : limits_(limits) {}

  bool header(std::string_view line);
  bool body(std::string_view bytes);
  /// The bytes of both bodies that have moved so far.
  void moved(long long sent, long long received);

  bool too_long() const { return too_long_; }
  /// Have bytes come too slowly for too long? One now and then makes no answer.
  bool is_silent(Clock::time_point now) const { return now - last_alive_ > limits_.idle; }
  HttpAnswer take() { return std::exchange(answer_, {}); }

 private:
  HttpAnswer answer_;
  HttpLimits limits_;
  std::size_t header_bytes_ = 0;
  bool too_long_ = false;
  bool has_begun_ = false;    ///< to arrive
  long long bytes_then_ = 0;  ///< that had moved when it was last alive
  Clock::time_point last_alive_ = Clock::now();
};

}  // namespace roomgen
