#pragma once

#include <cstddef>
#include <string_view>
#include <utility>

#include "transport.h"

namespace roomgen {

/// What arrives of an answer, within its bounds. Headers and bytes that go beyond them are refused.
class Inbox {
 public:
  using Seconds = HttpClock::Seconds;

  Inbox(const HttpLimits& limits, Seconds now) : limits_(limits), last_alive_(now) {}

  bool header(std::string_view line);
  bool body(std::string_view bytes);
  /// The bytes of both bodies that have moved so far.
  void moved(long long sent, long long received, Seconds now);

  bool too_long() const { return too_long_; }
  /// Have bytes come too slowly for too long? One now and then makes no answer.
  bool is_silent(Seconds now) const { return now - last_alive_ > limits_.idle; }
  HttpAnswer take() { return std::exchange(answer_, {}); }

 private:
  HttpAnswer answer_;
  HttpLimits limits_;
  std::size_t header_bytes_ = 0;
  bool too_long_ = false;
  bool has_begun_ = false;    ///< to arrive
  long long bytes_then_ = 0;  ///< that had moved when it was last alive
  Seconds last_alive_;
};

}  // namespace roomgen
