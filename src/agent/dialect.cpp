#include "dialect.h"

#include <algorithm>
#include <array>

#include "roomgen/base/text.h"

namespace roomgen {

bool refuses_option(int status, std::string_view complaint) {
  if (status == 400 || status == 422) return true;
  const std::string words = lower(complaint);
  const auto names = [&](std::string_view word) { return words.find(word) != words.npos; };
  return (status == 500 || status == 501) &&
         (names("grammar") || names("json_schema") || names("response_format"));
}

bool refuses_pictures(int status, const ChatRequest& request, std::string_view complaint) {
  constexpr std::array statuses = {400, 404, 415, 422, 500, 501};
  if (std::find(statuses.begin(), statuses.end(), status) == statuses.end()) return false;
  const auto& messages = request.messages;
  if (std::all_of(messages.begin(), messages.end(), [](const auto& m) { return m.images.empty(); }))
    return false;
  const std::string words = lower(complaint);
  constexpr std::array names = {"image", "vision", "multimodal", "mmproj",
                                "content must be a string"};
  return std::any_of(names.begin(), names.end(),
                     [&](const char* name) { return words.find(name) != words.npos; });
}

std::optional<Dialect> concede(const Dialect& refused, const ChatRequest& request,
                               std::string_view complaint) {
  using TokenLimit = Dialect::TokenLimit;
  const std::string words = lower(complaint);
  const auto names = [&](std::string_view option) { return words.find(option) != words.npos; };
  Dialect next = refused;
  if (!refused.token_limit_settled && (names("max_tokens") || names("max_completion_tokens"))) {
    next.token_limit = refused.token_limit == TokenLimit::max_tokens
                           ? TokenLimit::max_completion_tokens
                           : TokenLimit::max_tokens;
    next.token_limit_settled = true;
    return next;
  }
  if (refused.thinking && request.thinking > 0 && (names("reasoning") || names("thinking"))) {
    next.thinking = false;
    return next;
  }
  if (refused.stream && names("stream")) {
    next.stream = false;
    return next;
  }
  if (refused.temperature && names("temperature")) {
    next.temperature = false;
    return next;
  }
  if (refused.schema && !request.schema.is_null()) {
    next.schema = false;
    return next;
  }
  return std::nullopt;
}

}  // namespace roomgen
