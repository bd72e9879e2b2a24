#pragma once

#include <string>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/json.h"
#include "roomgen/base/result.h"

namespace roomgen {

/// One message of a conversation.
struct ChatMessage {
  enum class Role { system, user, assistant };
  Role role = Role::user;
  std::string text;                 ///< UTF-8
  std::vector<std::string> images;  ///< whole PNG files, shown after the text; only from the user
};

/// "system", "user" or "assistant".
const char* name(ChatMessage::Role role);

/// What a model is asked. Two requests with equal fields, `cancel` aside, are the same question.
struct ChatRequest {
  std::vector<ChatMessage> messages;
  /// JSON schema of the answer, for models that can be held to one; null when prose is fine. The
  /// messages say the same in words, for those that cannot.
  Json schema;
  std::string schema_name = "answer";
  int max_tokens = 4096;  ///< of the answer
  double temperature = 0.0;
  CancelToken cancel;  ///< ends the call at once
};

struct ChatReply {
  std::string text;
  std::string model;           ///< as the endpoint names it
  long long input_tokens = 0;  ///< as the endpoint counts them, over all attempts
  long long output_tokens = 0;
  double seconds = 0.0;  ///< all attempts and the waits between them
  int attempts = 1;
  bool cut_off = false;  ///< it ended where ChatRequest::max_tokens were spent
};

/// A language model, or whoever plays one. Wrappers add recording, replay, caching and limits
/// (chat_decorators.h).
class ChatModel {
 public:
  virtual ~ChatModel() = default;

  /// Fails with
  ///   unavailable    the endpoint cannot be used at all (no such host, wrong key, unknown model):
  ///                  asking again will not help
  ///   io             this call failed, after the retries that make sense; another one may succeed
  ///   limit          a bound on time, size, calls, tokens or money was reached
  ///   cancelled      the request's token was set
  virtual Result<ChatReply> chat(const ChatRequest& request) = 0;
};

}  // namespace roomgen
