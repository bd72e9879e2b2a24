#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "roomgen/agent/http_model.h"
#include "server.h"

/// The key of all tests: it must never be seen outside a request's headers.
inline const std::string secret = "sk-test-THE-SECRET-0123456789";

/// The environment's variables that models look at, gone for the time of a test but for a key.
class Environment {
 public:
  explicit Environment(const std::string& variable = "OPENAI_API_KEY",
                       const std::string& value = secret);
};

/// How a question to a server ended.
struct Asked {
  roomgen::Result<roomgen::ChatReply> reply = roomgen::Error{};
  double seconds = 0.0;

  bool ok() const { return reply.ok(); }
  std::string text() const { return reply ? reply->text : ""; }
  /// "kind: message" of the error; empty after success
  std::string error() const;
};

/// Options for quick tests: three attempts, a second for each, a twentieth between them.
roomgen::HttpModelOptions quick_options(const std::string& base_url);

roomgen::ChatRequest question(const std::string& text = "Where does the bed go?");
roomgen::ChatRequest question_with_schema();

Asked ask(roomgen::ChatModel& model, const roomgen::ChatRequest& request = question());
Asked ask(const roomgen::HttpModelOptions& options,
          const roomgen::ChatRequest& request = question());
