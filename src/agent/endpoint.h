#pragma once

#include <string>
#include <string_view>

#include "roomgen/agent/http_model.h"
#include "roomgen/base/result.h"

namespace roomgen {

/// Where questions are sent.
struct Endpoint {
  bool tls = true;
  std::string host;   ///< lower case; an IPv6 address keeps its brackets
  std::string port;   ///< empty: the scheme's own
  std::string path;   ///< "" or "/v1/chat/completions"
  std::string query;  ///< "" or "?api-version=…"

  std::string url() const { return shown() + query; }
  /// For messages: a query may hold secrets.
  std::string shown() const;
  /// "example.org:8443"
  std::string authority() const { return port.empty() ? host : host + ":" + port; }
  /// Whether it is this machine.
  bool is_loopback() const;
};

/// Takes a base URL apart. Names and passwords in it are refused: they would end up in logs.
Result<Endpoint> parse_base_url(std::string_view base_url);

ChatProtocol protocol_of(const Endpoint& endpoint);

/// The endpoint's own resource for chats: ".../chat/completions" or ".../v1/messages", unless the
/// path names it already.
Endpoint chat_endpoint(Endpoint base, ChatProtocol protocol);

}  // namespace roomgen
