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

  bool ok() const { return reply.ok(); }
  std::string text() const { return reply ? reply->text : ""; }
  /// "kind: message" of the error; empty after success
  std::string error() const;
};

/// A time of the test's own. It stands still but for waits, which are over at once and written down;
/// with a server and a `step` it goes on by that much each time it is looked at while the server has
/// the request of this attempt, and has not answered it.
class FakeTime {
 public:
  using Seconds = roomgen::HttpClock::Seconds;

  explicit FakeTime(const Server* server = nullptr, Seconds step = Seconds(0))
      : server_(server), step_(step) {}
  FakeTime(const FakeTime&) = delete;
  FakeTime& operator=(const FakeTime&) = delete;

  /// Must not outlive this.
  roomgen::HttpClock clock();
  const std::vector<double>& waits() const { return waits_; }

 private:
  const Server* server_;
  Seconds step_, now_{0};
  std::vector<double> waits_;
};

/// Options for quick tests: three attempts, and a twentieth of a second between them.
roomgen::HttpModelOptions quick_options(const std::string& base_url);
/// The same in a time that is not the machine's.
roomgen::HttpModelOptions quick_options(const std::string& base_url, FakeTime& time);

roomgen::ChatRequest question(const std::string& text = "Where does the bed go?");
roomgen::ChatRequest question_with_schema();

Asked ask(roomgen::ChatModel& model, const roomgen::ChatRequest& request = question());
Asked ask(const roomgen::HttpModelOptions& options,
          const roomgen::ChatRequest& request = question());
