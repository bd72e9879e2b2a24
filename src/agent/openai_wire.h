#pragma once

#include "wire.h"

namespace roomgen {

/// The body of POST …/chat/completions.
Json openai_body(const ChatRequest& request, const std::string& model, const Dialect& dialect);

Result<ChatReply> read_openai_reply(const Json& answer, const std::string& source);

}  // namespace roomgen
