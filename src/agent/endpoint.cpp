#include "endpoint.h"

#include <algorithm>
#include <cctype>

#include "roomgen/base/text.h"

namespace roomgen {

namespace {

Error url_error(const std::string& what) {
  return {Error::Kind::invalid_input, "base URL: " + what +
                                          "; expected something like https://api.openai.com/v1 or "
                                          "http://localhost:8080/v1"};
}

bool has_blank_or_control(std::string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](unsigned char c) { return c <= 0x20 || c == 0x7F; });
}

bool is_port(std::string_view text) {
  return !text.empty() && text.size() <= 5 &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); });
}

// "host", "host:port", "[::1]:port"
bool split_authority(std::string_view text, Endpoint& endpoint) {
  const auto bracket = text.find(']');
  const auto colon = text.find(':', bracket == std::string_view::npos ? 0 : bracket);
  endpoint.host = lower(text.substr(0, colon));
  if (colon != std::string_view::npos) {
    endpoint.port = text.substr(colon + 1);
    if (!is_port(endpoint.port)) return false;
  }
  return !endpoint.host.empty();
}

std::string_view without_slashes(std::string_view path) {
  while (!path.empty() && path.back() == '/') path.remove_suffix(1);
  return path;
}

}  // namespace

std::string Endpoint::shown() const {
  return (tls ? "https://" : "http://") + authority() + path;
}

bool Endpoint::is_loopback() const {
  return host == "localhost" || host.ends_with(".localhost") || host == "[::1]" ||
         (host.starts_with("127.") && host.find_first_not_of("0123456789.") == std::string::npos);
}

Result<Endpoint> parse_base_url(std::string_view base_url) {
  if (has_blank_or_control(base_url)) return url_error("it contains blanks or control characters");
  const auto scheme_end = base_url.find("://");
  const std::string scheme = lower(base_url.substr(0, scheme_end));
  if (scheme_end == std::string_view::npos || (scheme != "https" && scheme != "http"))
    return url_error("it does not begin with https:// or http://");

  Endpoint endpoint;
  endpoint.tls = scheme == "https";
  std::string_view rest = base_url.substr(scheme_end + 3);
  rest = rest.substr(0, rest.find('#'));
  const auto authority = rest.substr(0, rest.find_first_of("/?"));
  rest.remove_prefix(authority.size());
  if (authority.find('@') != std::string_view::npos)
    return url_error("it contains a name or password; keys belong in the environment");
  if (!split_authority(authority, endpoint)) return url_error("it names no host, or no valid port");
  const auto query = rest.find('?');
  if (query != std::string_view::npos) endpoint.query = rest.substr(query);
  endpoint.path = without_slashes(rest.substr(0, query));
  return endpoint;
}

ChatProtocol protocol_of(const Endpoint& endpoint) {
  const bool anthropic =
      endpoint.host == "anthropic.com" || endpoint.host.ends_with(".anthropic.com");
  return anthropic ? ChatProtocol::anthropic : ChatProtocol::openai;
}

Endpoint chat_endpoint(Endpoint base, ChatProtocol protocol) {
  const std::string_view resource =
      protocol == ChatProtocol::anthropic ? "/messages" : "/chat/completions";
  if (base.path.ends_with(resource)) return base;
  if (protocol == ChatProtocol::anthropic && !base.path.ends_with("/v1")) base.path += "/v1";
  base.path += resource;
  return base;
}

}  // namespace roomgen
