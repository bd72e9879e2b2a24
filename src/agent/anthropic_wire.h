#pragma once

#include "wire.h"

namespace roomgen {

/// The body of POST …/v1/messages. A schema goes out as the input of a tool that must be used.
Json anthropic_body(const ChatRequest& request, const std::string& model, const Dialect& dialect);

Result<ChatReply> read_anthropic_reply(const Json& answer, const std::string& source);

}  // namespace roomgen
