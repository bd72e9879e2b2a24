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

  /// `limit`: bytes of the body.
  explicit Inbox(std::size_t limit) : limit_(limit) {}

  bool header(std::string_view line);
  bool body(std::string_view bytes);
  /// The bytes that have moved so far, in both directions.
  void moved(long long bytes);

  bool too_long() const { return too_long_; }
  Clock::time_point last_moved() const { return last_moved_; }
  HttpAnswer take() { return std::exchange(answer_, {}); }

 private:
  HttpAnswer answer_;
  std::size_t limit_;
  std::size_t header_bytes_ = 0;
  bool too_long_ = false;
  long long bytes_moved_ = 0;
  Clock::time_point last_moved_ = Clock::now();
};

}  // namespace roomgen
