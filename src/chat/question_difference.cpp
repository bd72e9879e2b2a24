#include "question_difference.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/json_values.h"
#include "chat_question.h"
#include "roomgen/base/json.h"

namespace roomgen {

namespace {

constexpr std::size_t before_bytes = 24;
constexpr std::size_t after_bytes = 48;

const Json nothing;

// Recordings may be edited by hand: whatever is missing reads as null.
const Json& message(const Json& question, std::size_t i) {
  const Json& messages = member_of(question, "messages");
  return messages.is_array() && i < messages.size() ? messages[i] : nothing;
}

std::size_t message_count(const Json& question) {
  const Json& messages = member_of(question, "messages");
  return messages.is_array() ? messages.size() : 0;
}

std::size_t common_prefix(std::string_view a, std::string_view b) {
  return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first -
                                  a.begin());
}

std::string text_of(const Json& json) {
  return json.is_string() ? json.get<std::string>() : json_line(json);
}

// Equal messages first, then equal bytes of the first other one.
std::pair<std::size_t, std::size_t> likeness(const Json& a, const Json& b) {
  std::size_t i = 0;
  const std::size_t count = std::min(message_count(a), message_count(b));
  while (i < count && message(a, i) == message(b, i)) ++i;
  return {i, common_prefix(text_of(member_of(message(a, i), "text")),
                           text_of(member_of(message(b, i), "text")))};
}

bool inside_character(std::string_view text, std::size_t i) {
  return i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
}

// What stands around byte `at`, on one line and in whole characters.
std::string around(std::string_view text, std::size_t at) {
  std::size_t from = at > before_bytes ? at - before_bytes : 0;
  std::size_t to = std::min(text.size(), at + after_bytes);
  while (inside_character(text, from)) ++from;
  while (inside_character(text, to)) ++to;
  std::string excerpt(text.substr(from, to - from));
  std::replace_if(
      excerpt.begin(), excerpt.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
  return (from > 0 ? "…" : "") + excerpt + (to < text.size() ? "…" : "");
}

std::string both(const Json& recorded, const Json& asked) {
  const std::string a = text_of(recorded), b = text_of(asked);
  const std::size_t at = common_prefix(a, b);
  return "recorded \"" + around(a, at) + "\", asked \"" + around(b, at) + "\"";
}

std::string message_difference(const Json& recorded, const Json& asked) {
  if (recorded.is_null())
    return "was not recorded: \"" + around(text_of(member_of(asked, "text")), 0) + "\"";
  if (asked.is_null()) return "was recorded, but not asked";
  for (const char* key : {"role", "text"})
    if (member_of(recorded, key) != member_of(asked, key))
      return both(member_of(recorded, key), member_of(asked, key));
  return "other images: " + both(member_of(recorded, "images"), member_of(asked, "images"));
}

}  // namespace

const RecordedAnswer* nearest_question(const std::vector<RecordedAnswer>& recorded,
                                       const Json& question) {
  const auto nearest = std::max_element(
      recorded.begin(), recorded.end(), [&](const RecordedAnswer& a, const RecordedAnswer& b) {
        return likeness(a.question, question) < likeness(b.question, question);
      });
  return nearest == recorded.end() ? nullptr : &*nearest;
}

std::string describe_difference(const Json& recorded, const Json& asked) {
  const std::size_t count = std::max(message_count(recorded), message_count(asked));
  for (std::size_t i = 0; i < count; ++i) {
    const Json& a = message(recorded, i);
    const Json& b = message(asked, i);
    if (a == b) continue;
    const std::string role = text_of(member_of(b.is_null() ? a : b, "role"));
    return "message " + std::to_string(i + 1) + " (" + role + "): " + message_difference(a, b);
  }
  for (const char* key : {"schema", "schema_name", "max_tokens", "temperature", "thinking"})
    if (member_of(recorded, key) != member_of(asked, key))
      return std::string(key) + ": " + both(member_of(recorded, key), member_of(asked, key));
  return "nothing but the recorded key";
}

}  // namespace roomgen
