#include "server.h"

#include <exception>
#include <set>
#include <utility>
#include <vector>

#include "input_schema.h"
#include "meant_input.h"
#include "page.h"
#include "roomgen/base/text.h"

namespace roomgen::mcp {

namespace {

constexpr std::size_t most_waiting = 100;

// What may take time waits for its turn, the rest is answered by the thread that reads.
bool takes_time(const std::string& method) {
  return method == "tools/call" || method == "resources/read" || method == "resources/list";
}

bool may_be_kept(const std::string& method) {
  static const std::set<std::string> methods = {"server/discover", "tools/list", "resources/list",
                                                "resources/templates/list", "resources/read"};
  return methods.count(method) > 0;
}

Json capabilities() { return {{"tools", Json::object()}, {"resources", Json::object()}}; }

// What went wrong is for the model to read, which then may ask better.
Json failed(const std::string& why) {
  return {{"content", Json::array({Json{{"type", "text"}, {"text", why}}})}, {"isError", true}};
}

Json succeeded(const ToolAnswer& answer) {
  Json result = {{"content", answer.content}};
  if (!answer.data.is_null()) result["structuredContent"] = answer.data;
  result["isError"] = false;
  return result;
}

std::string text_of(const Json& params, const char* key) {
  const auto found = params.find(key);
  return found != params.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace

Server::Server(Offer offer, Send send)
    : offer_(std::move(offer)),
      info_({{"name", "roomgen"}, {"title", "roomgen: furnished 3D rooms"}, {"version", offer_.version}}),
      send_(std::move(send)) {}

void Server::send(const Json& message) {
  const std::string line = to_line(message);
  const std::lock_guard lock(sending_);
  send_(line);
}

void Server::send_outcome(const Message& request, const Manner& manner, Outcome outcome) {
  if (const auto* fault = std::get_if<Fault>(&outcome)) return send(refusal(request.id, *fault));
  Json result = in_manner(manner, std::get<Json>(std::move(outcome)), info_, may_be_kept(request.method));
  send(reply(request.id, std::move(result)));
}

void Server::take(std::string_view line) {
  for (const auto& reading : read_messages(line)) {
    if (const auto* refused = std::get_if<Refused>(&reading)) send(refusal(refused->id, refused->fault));
    else take(std::get<Message>(reading));
  }
}

void Server::refuse_long_line() {
  send(refusal(nullptr, {invalid_request, "a message of more than " + std::to_string(max_message_bytes) +
                                              " bytes; send less at a time"}));
}

void Server::take(const Message& message) {
  if (message.is_notification()) return note(message);
  const auto manner = manner_of(message);
  if (const auto* fault = std::get_if<Fault>(&manner)) return send(refusal(message.id, *fault));
  if (takes_time(message.method)) return enqueue({message, std::get<Manner>(manner), {}});
  if (auto outcome = answer_now(message))
    return send_outcome(message, std::get<Manner>(manner), *std::move(outcome));
  send(refusal(message.id, {method_not_found, "unknown method \"" + shortened(message.method, 100) + "\""}));
}

// Of notifications only the one that stops a call asks for anything.
void Server::note(const Message& notification) {
  if (notification.method != "notifications/cancelled") return;
  const auto id = notification.params.find("requestId");
  if (id == notification.params.end()) return;
  const std::lock_guard lock(calling_);
  for (auto& call : waiting_)
    if (call.request.id == *id) call.cancel.cancel();
  if (running_ && running_->request.id == *id) running_->cancel.cancel();
}

std::optional<Server::Outcome> Server::answer_now(const Message& request) const {
  if (request.method == "initialize") return initialize(request.params);
  if (request.method == "server/discover") return discover();
  if (request.method == "ping") return Json::object();
  if (request.method == "tools/list") return Json{{"tools", offer_.about["tools"]}};
  if (request.method == "resources/templates/list")
    return Json{{"resourceTemplates", offer_.about["resourceTemplates"]}};
  return std::nullopt;
}

Server::Outcome Server::initialize(const Json& params) const {
  const std::string asked = text_of(params, "protocolVersion");
  if (asked.empty()) return Fault{invalid_params, "/params/protocolVersion: expected a text such as \"2025-11-25\""};
  return Json{{"protocolVersion", agreed_version(asked)},
              {"capabilities", capabilities()},
              {"serverInfo", info_},
              {"instructions", offer_.about["instructions"]}};
}

Server::Outcome Server::discover() const {
  return Json{{"supportedVersions", spoken_versions()},
              {"capabilities", capabilities()},
              {"instructions", offer_.about["instructions"]}};
}

void Server::enqueue(Call call) {
  {
    const std::lock_guard lock(calling_);
    if (waiting_.size() < most_waiting) {
      waiting_.push_back(std::move(call));
      called_.notify_one();
      return;
    }
  }
  send(refusal(call.request.id, {busy, std::to_string(most_waiting) + " calls wait already; wait for an answer"}));
}

void Server::close() {
  const std::lock_guard lock(calling_);
  closed_ = true;
  called_.notify_all();
}

void Server::stop() {
  const std::lock_guard lock(calling_);
  closed_ = true;
  waiting_.clear();
  if (running_) running_->cancel.cancel();
  called_.notify_all();
}

bool Server::work() {
  std::unique_lock lock(calling_);
  called_.wait(lock, [this] { return closed_ || !waiting_.empty(); });
  if (waiting_.empty()) return false;
  running_ = std::move(waiting_.front());
  waiting_.pop_front();
  const Call call = *running_;
  lock.unlock();
  if (!call.cancel.cancelled()) {
    auto outcome = perform(call);
    if (!call.cancel.cancelled()) send_outcome(call.request, call.manner, std::move(outcome));
  }
  lock.lock();
  running_.reset();
  return true;
}

// Whatever a call does, the next one is answered.
Server::Outcome Server::perform(const Call& call) {
  try {
    if (call.request.method == "tools/call") return call_tool(call);
    if (call.request.method == "resources/read") return read_resource(call);
    return Json{{"resources", offer_.list_resources()}};
  } catch (const std::exception& error) {
    return Fault{internal_error, std::string("roomgen failed at this: ") + error.what()};
  }
}

const Json* Server::tool_named(const std::string& name) const {
  for (const auto& tool : offer_.about["tools"])
    if (tool["name"] == name) return &tool;
  return nullptr;
}

// The protocol wants each amount to be larger than the one before: what is no further is not sent.
Progress Server::progress_to(const Json& token) {
  return [this, token, last = -1.0](double done, double total, const std::string& what) mutable {
    if (!(done > last)) return;
    last = done;
    const Json params = {
        {"progressToken", token}, {"progress", done}, {"total", total}, {"message", what}};
    send(notification("notifications/progress", params));
  };
}

Server::Outcome Server::call_tool(const Call& call) {
  const Json& params = call.request.params;
  const std::string name = text_of(params, "name");
  const Json* tool = tool_named(name);
  if (!tool) {
    std::vector<std::string> names;
    for (const auto& each : offer_.tools) names.push_back(each.first);
    return Fault{invalid_params, "unknown tool \"" + shortened(name, 100) + "\"; there are " + join(names, ", ")};
  }
  ToolCall made;
  const Json& schema = (*tool)["inputSchema"];
  if (const auto given = params.find("arguments"); given != params.end() && !given->is_null())
    made.arguments = as_meant(schema, *given);
  made.cancel = call.cancel;
  const Json meta = params.value("_meta", Json());
  if (meta.is_object() && meta.contains("progressToken"))
    made.progress = progress_to(meta["progressToken"]);
  if (auto status = check_input(schema, made.arguments); !status)
    return failed(name + ": " + status.error().message);
  auto answer = offer_.tools.at(name)(made);
  if (!answer) return failed(answer.error().message);
  keep_within_bounds(*answer);
  return succeeded(*answer);
}

Server::Outcome Server::read_resource(const Call& call) const {
  const std::string uri = text_of(call.request.params, "uri");
  if (uri.empty()) return Fault{invalid_params, "/params/uri: expected a text"};
  const auto text = offer_.read_resource(uri);
  const char* type = uri.ends_with(".md") ? "text/markdown" : "application/json";
  const Json content = {{"uri", uri}, {"mimeType", type}, {"text", text ? *text : ""}};
  if (text) return Json{{"contents", Json::array({content})}};
  // Since requests name their revision, the protocol has no code of its own for that.
  const ErrorCode code = call.manner.names_version ? invalid_params : resource_not_found;
  return Fault{code, text.error().message, {{"uri", uri}}};
}

}  // namespace roomgen::mcp
