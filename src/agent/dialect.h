#pragma once

#include <optional>
#include <string_view>

#include "roomgen/chat/chat_model.h"

namespace roomgen {

/// Which parts of a request an endpoint takes, as far as is known.
struct Dialect {
  enum class TokenLimit { max_tokens, max_completion_tokens };

  bool schema = true;
  bool temperature = true;
  bool thinking = true;
  bool stream = true;  ///< OpenAI's protocol: bytes come early, so that silence means something
  TokenLimit token_limit = TokenLimit::max_tokens;
  bool token_limit_settled = false;  ///< the other name was tried already, or there is none
};

/// Whether a status and the endpoint's complaint say that it did not take an option: 400 and 422 by
/// rule; some servers fail with 5xx over a schema that they cannot turn into a grammar.
bool refuses_option(int status, std::string_view complaint);

/// Whether an endpoint refused a question for its pictures, as those of models without eyes do.
bool refuses_pictures(int status, const ChatRequest& request, std::string_view complaint);

/// The next dialect to try after an endpoint refused a request with a `complaint`; nothing when
/// there is nothing left to give up. A complaint that names no option costs the schema, the least
/// common of them.
std::optional<Dialect> concede(const Dialect& refused, const ChatRequest& request,
                               std::string_view complaint);

}  // namespace roomgen
