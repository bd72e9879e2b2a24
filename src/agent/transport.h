#pragma once

#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "roomgen/agent/http_model.h"
#include "roomgen/base/cancel.h"

namespace roomgen {

struct HttpRequest {
  std::string url;
  std::vector<std::pair<std::string, std::string>> headers;
  std::string body;
  bool direct = false;  ///< past any proxy that the environment names
};

/// What a server answered, whatever its status.
struct HttpAnswer {
  int status = 0;
  std::string location;  ///< of these headers, "" if absent
  std::string retry_after;
  std::string body;
};

/// Why there is no answer.
struct HttpFailure {
  enum class Kind { no_such_host, refused, not_taken, tls, timed_out, silent, too_long, broken, cancelled };
  Kind kind = Kind::broken;
  std::string what;
  bool sent = false;  ///< the server has got the request, or a part of it
};

using HttpOutcome = std::variant<HttpAnswer, HttpFailure>;

/// Sends requests, keeps connections open between them, follows no redirect.
class Transport {
 public:
  explicit Transport(HttpClock clock);
  ~Transport();

  /// Ends within the limits, and within a tenth of a second once `cancel` is set.
  HttpOutcome post(const HttpRequest& request, const HttpLimits& limits, const CancelToken& cancel);

 private:
  class Connections;
  HttpClock clock_;
  std::unique_ptr<Connections> connections_;
};

}  // namespace roomgen
