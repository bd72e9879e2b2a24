#pragma once

#include <string>

#include "roomgen/base/result.h"
#include "roomgen/chat/chat_model.h"

namespace roomgen {

/// With a model that fails: one that cannot be used, or that fails again and again, is not asked any more. What
/// ran out of time has kept everybody waiting and counts twice.
class Patience {
 public:
  void note(const Result<ChatReply>& reply) {
    if (reply) failures_ = 0;
    if (reply || reply.error().kind == Error::Kind::cancelled) return;
    failures_ += reply.error().kind == Error::Kind::limit ? 2 : 1;
    if (reply.error().kind == Error::Kind::unavailable || failures_ >= most_failures) lost_ = reply.error().message;
  }

  /// Why the model is not asked any more; empty while it is.
  const std::string& lost() const { return lost_; }

 private:
  static constexpr int most_failures = 3;  // one after the other

  int failures_ = 0;  ///< since the last answer
  std::string lost_;
};

}  // namespace roomgen
