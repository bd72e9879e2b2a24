#pragma once

#include <atomic>
#include <memory>

namespace roomgen {

/// A flag that several owners share: whoever asked for long work may stop it, from another thread or
/// a signal handler. Copies refer to the same flag. Long loops test `cancelled()` and return
/// Error::Kind::cancelled with what is whole so far.
class CancelToken {
 public:
  CancelToken() : flag_(std::make_shared<std::atomic<bool>>(false)) {}

  void cancel() noexcept { flag_->store(true, std::memory_order_relaxed); }
  bool cancelled() const noexcept { return flag_->load(std::memory_order_relaxed); }

 private:
  std::shared_ptr<std::atomic<bool>> flag_;
};

}  // namespace roomgen
