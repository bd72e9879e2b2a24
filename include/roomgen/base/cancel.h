#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <optional>

namespace roomgen {

/// A flag that several owners share: whoever asked for long work may stop it, from another thread or
/// a signal handler. Copies refer to the same flag. Long loops test `cancelled()` and return
/// Error::Kind::cancelled with what is whole so far.
class CancelToken {
 public:
  CancelToken() : flag_(std::make_shared<std::atomic<bool>>(false)) {}

  void cancel() noexcept { flag_->store(true, std::memory_order_relaxed); }
  bool cancelled() const noexcept {
    return flag_->load(std::memory_order_relaxed) || (end_ && Clock::now() >= *end_);
  }

  /// The same flag with an end of its own: cancelled when the flag is set, or after this time.
  /// A time of more than thirty years is so long.
  CancelToken within(std::chrono::duration<double> time) const {
    constexpr std::chrono::duration<double> longest(1e9);  // what a clock can count
    CancelToken token = *this;
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(time < longest ? time : longest);
    token.end_ = end_ ? std::min(*end_, end) : end;
    return token;
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::shared_ptr<std::atomic<bool>> flag_;
  std::optional<Clock::time_point> end_;
};

}  // namespace roomgen
