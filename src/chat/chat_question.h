#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "base/json_reader.h"
#include "roomgen/base/json.h"
#include "roomgen/chat/chat_model.h"

namespace roomgen {

/// A request as recordings keep it: everything that makes it the same question, images as their
/// SHA-256.
Json question_json(const ChatRequest& request);

/// The name of a question: SHA-256 of its JSON.
std::string question_key(const Json& question);

Json reply_json(const ChatReply& reply);
ChatReply read_reply(const JsonReader& json);

}  // namespace roomgen
