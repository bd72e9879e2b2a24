#include "endpoint.h"

#include <curl/curl.h>

#include <memory>

#include "roomgen/base/text.h"

namespace roomgen {

namespace {

struct UrlCleanup {
  void operator()(CURLU* url) const { curl_url_cleanup(url); }
};
using Url = std::unique_ptr<CURLU, UrlCleanup>;

Error url_error(const std::string& what) {
  return {Error::Kind::invalid_input, "base URL: " + what +
                                          "; expected something like https://api.openai.com/v1 or "
                                          "http://localhost:8080/v1"};
}

// Empty if the URL lacks it.
std::string part_of(const Url& url, CURLUPart which) {
  char* text = nullptr;
  if (curl_url_get(url.get(), which, &text, 0) != CURLUE_OK) return {};
  const std::unique_ptr<char, decltype(&curl_free)> freed(text, curl_free);
  return text;
}

std::string without_slashes(std::string path) {
  path.erase(path.find_last_not_of('/') + 1);
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
  const Url url(curl_url());
  if (!url || base_url.find('\0') != std::string_view::npos) return url_error("it cannot be read");
  const CURLUcode code = curl_url_set(url.get(), CURLUPART_URL, std::string(base_url).c_str(),
                                      CURLU_DISALLOW_USER);
  if (code == CURLUE_USER_NOT_ALLOWED)
    return url_error("it contains a name or password; keys belong in the environment");
  if (code != CURLUE_OK) return url_error(curl_url_strerror(code));
  const std::string scheme = part_of(url, CURLUPART_SCHEME);
  if (scheme != "https" && scheme != "http")
    return url_error("it does not begin with https:// or http://");

  Endpoint endpoint;
  endpoint.tls = scheme == "https";
  endpoint.host = lower(part_of(url, CURLUPART_HOST));
  endpoint.port = part_of(url, CURLUPART_PORT);
  endpoint.path = without_slashes(part_of(url, CURLUPART_PATH));
  if (const std::string query = part_of(url, CURLUPART_QUERY); !query.empty())
    endpoint.query = "?" + query;
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
