#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "json_rpc.h"
#include "offer.h"
#include "versions.h"

namespace roomgen::mcp {

/// The Model Context Protocol, server's side, whatever carries its lines. One thread takes messages in and answers
/// what is known at once; another works on the calls that take their time, one after the other. Nothing that a
/// client says ends it.
class Server {
 public:
  /// Sends one line. Called by both threads, but never by both at once.
  using Send = std::function<void(const std::string& line)>;

  Server(Offer offer, Send send);

  /// A line that came in.
  void take(std::string_view line);
  /// One that was too long to be read.
  void refuse_long_line();
  /// No more lines will come.
  void close();
  /// All calls stop as soon as they can and are not answered.
  void stop();

  /// Waits for a call and answers it. False when none is left and none will come.
  bool work();

 private:
  struct Call {
    Message request;
    Manner manner;
    CancelToken cancel;
  };
  using Outcome = std::variant<Json, Fault>;

  void take(const Message& message);
  void note(const Message& notification);
  std::optional<Outcome> answer_now(const Message& request) const;
  void enqueue(Call call);
  Outcome perform(const Call& call);
  Outcome initialize(const Json& params) const;
  Outcome discover() const;
  Progress progress_to(const Json& token);
  Outcome call_tool(const Call& call);
  Outcome read_resource(const Call& call) const;
  const Json* tool_named(const std::string& name) const;
  void send_outcome(const Message& request, const Manner& manner, Outcome outcome);
  void send(const Json& message);

  Offer offer_;
  Json info_;  ///< the server's name and version
  Send send_;
  std::mutex sending_;

  std::mutex calling_;  ///< guards what follows
  std::condition_variable called_;
  std::deque<Call> waiting_;
  std::optional<Call> running_;
  bool closed_ = false;
};

}  // namespace roomgen::mcp
