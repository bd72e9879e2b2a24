#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/chat/chat_model.h"

namespace roomgen {

/// One line of a recording: {"key", "request", "reply"} or {"key", "request", "error"}.
struct RecordedAnswer {
  int line = 0;  ///< counted from 1
  std::string key;
  Json question;
  Result<ChatReply> answer = ChatReply{};
};

std::string recorded_line(const ChatRequest& request, const Result<ChatReply>& answer);

/// All lines of a recording; `source` names it in errors.
Result<std::vector<RecordedAnswer>> parse_recording(std::string_view text,
                                                    const std::string& source);

}  // namespace roomgen
