#include "roomgen/agent/http_model.h"

#include <nlohmann/json.hpp>

#include "clock.h"
#include "http_status.h"
#include "retrying_sender.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "wire.h"

namespace roomgen {

namespace {

Dialect first_dialect(const Destination& destination) {
  Dialect dialect;
  dialect.token_limit_settled = destination.protocol == ChatProtocol::anthropic;
  if (destination.endpoint.host.ends_with("openai.com"))
    dialect.token_limit = Dialect::TokenLimit::max_completion_tokens;
  return dialect;
}

std::vector<std::pair<std::string, std::string>> headers_for(const Destination& destination) {
  std::vector<std::pair<std::string, std::string>> headers = {{"Content-Type", "application/json"},
                                                              {"Accept", "application/json"}};
  const bool anthropic = destination.protocol == ChatProtocol::anthropic;
  if (anthropic) headers.emplace_back("anthropic-version", "2023-06-01");
  if (destination.key.empty()) return headers;
  if (anthropic)
    headers.emplace_back("x-api-key", destination.key.reveal());
  else
    headers.emplace_back("Authorization", "Bearer " + destination.key.reveal());
  return headers;
}

class HttpModel final : public ChatModel {
 public:
  HttpModel(const HttpModelOptions& options, Destination destination)
      : model_(options.model),
        log_(options.log),
        dialect_(first_dialect(destination)),
        sender_(std::move(destination), options.limits, options.retry, completed(options.clock),
                options.log) {}

  // Asks, with fewer options each time the endpoint refuses one; what it took is remembered.
  Result<ChatReply> chat(const ChatRequest& request) override {
    Progress progress = sender_.begin(request);
    Dialect dialect = dialect_;
    while (true) {
      const auto answer = sender_.send(http_request(request, dialect), progress);
      if (!answer) return answer.error();
      if (answer->status >= 200 && answer->status < 300) {
        dialect_ = dialect;
        return read(*answer, progress);
      }
      const std::string complaint = complaint_in(answer->body);
      if (refuses_pictures(answer->status, request, complaint))
        return Error{Error::Kind::invalid_input,
                     key().scrub(endpoint().shown() + ": takes no pictures (" + complaint + ")")};
      const auto next = refuses_option(answer->status, complaint)
                            ? concede(dialect, request, complaint)
                            : std::nullopt;
      if (!next) return scrubbed(status_error(*answer, endpoint(), protocol()));
      log(log_, LogLevel::info,
          key().scrub(endpoint().shown() + ": refused an option (" + complaint +
                      "); asking again without it"));
      dialect = *next;
    }
  }

 private:
  const Endpoint& endpoint() const { return sender_.destination().endpoint; }
  ChatProtocol protocol() const { return sender_.destination().protocol; }

  HttpRequest http_request(const ChatRequest& request, const Dialect& dialect) const {
    const Json body = protocol() == ChatProtocol::anthropic
                          ? anthropic_body(request, model_, dialect)
                          : openai_body(request, model_, dialect);
    HttpRequest http;
    http.url = endpoint().url();
    http.headers = headers_for(sender_.destination());
    http.body = json_line(body);
    http.direct = endpoint().is_loopback();
    return http;
  }

  Result<ChatReply> read(const HttpAnswer& answer, const Progress& progress) const {
    const std::string source = endpoint().shown();
    const auto json = parse_answer(answer.body, source);
    if (!json) return json.error();
    auto reply = protocol() == ChatProtocol::anthropic ? read_anthropic_reply(*json, source)
                                                       : read_openai_reply(*json, source);
    if (!reply) return scrubbed(reply.error());
    reply->text = key().scrub(std::move(reply->text));
    reply->model = reply->model.empty() ? model_ : key().scrub(std::move(reply->model));
    reply->attempts = progress.requests;
    reply->seconds = sender_.elapsed(progress).count();
    return reply;
  }

  // JSON may spell the key in another way than it was searched for in the bytes.
  Error scrubbed(const Error& error) const { return {error.kind, key().scrub(error.message)}; }
  const ApiKey& key() const { return sender_.destination().key; }

  std::string model_;
  LogSink log_;
  Dialect dialect_;
  RetryingSender sender_;
};

}  // namespace

Result<std::unique_ptr<ChatModel>> make_http_model(const HttpModelOptions& options) {
  if (trim(options.model).empty())
    return Error{Error::Kind::invalid_input, "which model? Give the name the endpoint knows it by"};
  const auto base = parse_base_url(options.base_url);
  if (!base) return base.error();
  Destination to;
  to.protocol = options.protocol.value_or(protocol_of(*base));
  to.endpoint = chat_endpoint(*base, to.protocol);
  auto key = read_api_key(to.protocol, to.endpoint, options.key_file);
  if (!key) return key.error();
  to.key = *std::move(key);
  return std::unique_ptr<ChatModel>(std::make_unique<HttpModel>(options, std::move(to)));
}

}  // namespace roomgen
