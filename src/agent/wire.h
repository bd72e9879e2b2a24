#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/json_reader.h"
#include "dialect.h"
#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/chat/chat_model.h"

namespace roomgen {

// What both protocols share and, below, what each sends and reads. Pure functions: no
// network here.

/// Longest text of an answer, bytes; the transport bounds the whole of it before.
inline constexpr std::size_t max_answer_text = 64u << 20;

/// An answer's body as JSON. `source` names the endpoint in errors, which say what came instead: a
/// web page, a text cut short, bytes that are no UTF-8.
Result<Json> parse_answer(std::string_view body, const std::string& source);

/// The endpoint's own words about a failure: the message in its JSON, or the beginning of the text;
/// empty for a web page.
std::string complaint_in(std::string_view body);

/// A reader of an answer and the first thing that was wrong with it.
struct AnswerReader {
  AnswerReader(const Json& answer, const std::string& source)
      : problems(source), root(answer, problems) {}

  JsonReader::Problems problems;
  JsonReader root;

  /// The tokens that "usage" counts under these names; none where the endpoint does not count.
  void read_usage(const char* input, const char* output, ChatReply& reply) const;
  /// What `reply` says if the answer was as the protocol has it and says anything.
  Result<ChatReply> finish(ChatReply reply, const std::string& source) const;
};

Error refused(const std::string& source, std::string_view why);

/// "image/png" or "image/jpeg", as the file's first bytes say.
std::string media_type(std::string_view file);

/// The body of POST …/chat/completions.
Json openai_body(const ChatRequest& request, const std::string& model, const Dialect& dialect);

Result<ChatReply> read_openai_reply(const Json& answer, const std::string& source);

/// The body of POST …/v1/messages. A schema goes out as the input of a tool that must be used.
Json anthropic_body(const ChatRequest& request, const std::string& model, const Dialect& dialect);

Result<ChatReply> read_anthropic_reply(const Json& answer, const std::string& source);

}  // namespace roomgen
