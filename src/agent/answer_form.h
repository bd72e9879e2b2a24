#pragma once

#include <string>
#include <string_view>

#include "roomgen/chat/chat_model.h"
#include "transport.h"

namespace roomgen {

/// An answer as the server meant it. Gateways report failures of the server behind them with status
/// 200 and a code in the body, which becomes the status; and they send comments ahead of an answer,
/// or an event stream where none was asked for (plain_json).
HttpAnswer as_meant(HttpAnswer answer);

/// The JSON of a body: without comment lines ahead of it, and the pieces of an event stream, as
/// OpenAI's protocol has it, as one completion. Other texts stay as they are.
std::string plain_json(std::string_view body);

/// What an answer took, as it says itself; nothing for one that reports a failure.
ChatUse use_of(const HttpAnswer& answer);

}  // namespace roomgen
