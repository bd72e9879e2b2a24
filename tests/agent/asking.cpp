#include "asking.h"

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "roomgen/base/json.h"

using namespace roomgen;

namespace {

const char* kind_name(Error::Kind kind) {
  switch (kind) {
    case Error::Kind::invalid_input:
      return "invalid_input";
    case Error::Kind::not_found:
      return "not_found";
    case Error::Kind::io:
      return "io";
    case Error::Kind::limit:
      return "limit";
    case Error::Kind::cancelled:
      return "cancelled";
    case Error::Kind::unavailable:
      return "unavailable";
  }
  return "?";
}

}  // namespace

Environment::Environment(const std::string& variable, const std::string& value) {
  for (const char* name : {"ROOMGEN_API_KEY", "OPENAI_API_KEY", "ANTHROPIC_API_KEY", "http_proxy",
                           "https_proxy", "HTTPS_PROXY", "all_proxy", "ALL_PROXY"})
    ::unsetenv(name);
  if (!variable.empty()) ::setenv(variable.c_str(), value.c_str(), 1);
}

std::string Asked::error() const {
  return reply ? "" : std::string(kind_name(reply.error().kind)) + ": " + reply.error().message;
}

HttpModelOptions quick_options(const std::string& base_url) {
  using Seconds = std::chrono::duration<double>;
  HttpModelOptions options;
  options.base_url = base_url;
  options.model = "tiny-1";
  options.retry.attempts = 3;
  options.retry.first_wait = options.retry.longest_wait = Seconds(0.05);
  options.retry.longest_retry_after = Seconds(2);
  options.retry.total = Seconds(60);
  return options;
}

HttpModelOptions quick_options(const std::string& base_url, FakeTime& time) {
  HttpModelOptions options = quick_options(base_url);
  options.clock = time.clock();
  return options;
}

HttpClock FakeTime::clock() {
  HttpClock clock;
  clock.now = [this] {
    if (server_ && server_->count() > waits_.size()) now_ += step_;
    return now_;
  };
  clock.pause = [this](Seconds duration, const CancelToken&) {
    now_ += duration;
    waits_.push_back(duration.count());
    return true;
  };
  return clock;
}

ChatRequest question(const std::string& text) {
  ChatRequest request;
  request.messages = {{ChatMessage::Role::system, "You furnish rooms.", {}},
                      {ChatMessage::Role::user, text, {}}};
  request.max_tokens = 100;
  return request;
}

ChatRequest question_with_schema() {
  ChatRequest request = question();
  request.schema = Json::parse(R"({"type": "object", "properties": {"size": {"type": "array"}},
                                   "required": ["size"], "additionalProperties": false})");
  return request;
}

Asked ask(ChatModel& model, const ChatRequest& request) {
  return {model.chat(request)};
}

Asked ask(const HttpModelOptions& options, const ChatRequest& request) {
  auto model = make_http_model(options);
  if (model) return ask(**model, request);
  return {model.error()};
}
