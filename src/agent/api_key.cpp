#include "api_key.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr std::size_t max_key_bytes = 4096;
constexpr std::size_t shortest_secret = 8;

const char* variable_of(ChatProtocol protocol) {
  return protocol == ChatProtocol::anthropic ? "ANTHROPIC_API_KEY" : "OPENAI_API_KEY";
}

struct Descriptor {
  int number;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

// A key goes into a header line: a line break would start another one.
Result<ApiKey> checked(std::string_view text, const std::string& source) {
  text = trim(text);
  const bool printable =
      std::all_of(text.begin(), text.end(), [](unsigned char c) { return c > 0x20 && c < 0x7F; });
  if (!printable)
    return Error{Error::Kind::invalid_input,
                 source + ": a key has no blanks, control characters or letters beyond ASCII"};
  if (text.size() > max_key_bytes)
    return Error{Error::Kind::invalid_input, source + ": too long for a key"};
  return ApiKey(std::string(text));
}

// The file that was opened is the one that is examined: its name may change hands in between.
Result<ApiKey> from_file(const std::filesystem::path& path) {
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
  struct stat status {};
  if (file.number < 0 || ::fstat(file.number, &status) != 0)
    return Error{errno == ENOENT ? Error::Kind::not_found : Error::Kind::io,
                 path.string() + ": cannot read the key: " + std::strerror(errno)};
  if (!S_ISREG(status.st_mode))
    return Error{Error::Kind::invalid_input, path.string() + ": the key file is no regular file"};
  if ((status.st_mode & 077) != 0) {
    char mode[8];
    std::snprintf(mode, sizeof mode, "%03o", static_cast<unsigned>(status.st_mode & 0777));
    return Error{Error::Kind::invalid_input, path.string() + ": others may read the key (mode " +
                                                 mode + "); run: chmod 600 " + path.string()};
  }
  std::string bytes(max_key_bytes + 1, '\0');
  const auto count = ::read(file.number, bytes.data(), bytes.size());
  if (count < 0)
    return Error{Error::Kind::io, path.string() + ": cannot read the key: " + std::strerror(errno)};
  bytes.resize(static_cast<std::size_t>(count));
  auto key = checked(bytes, path.string());
  if (key && key->empty())
    return Error{Error::Kind::invalid_input, path.string() + ": the key file is empty"};
  return key;
}

Error missing_key(ChatProtocol protocol, const Endpoint& endpoint) {
  return {Error::Kind::unavailable,
          std::string("no key for ") + endpoint.authority() + ": set " + variable_of(protocol) +
              " or name a key file; a server that needs no key: set ROOMGEN_API_KEY to nothing"};
}

Error clear_text(const Endpoint& endpoint) {
  return {Error::Kind::invalid_input,
          endpoint.shown() +
              ": the key would cross the network in clear text; use https, or set "
              "ROOMGEN_API_KEY to nothing if the server needs no key"};
}

Result<ApiKey> from_environment(ChatProtocol protocol, const Endpoint& endpoint) {
  if (const char* own = std::getenv("ROOMGEN_API_KEY")) return checked(own, "ROOMGEN_API_KEY");
  const char* value = std::getenv(variable_of(protocol));
  if (value && *value) return checked(value, variable_of(protocol));
  if (endpoint.is_loopback()) return ApiKey();
  return missing_key(protocol, endpoint);
}

}  // namespace

std::string ApiKey::scrub(std::string text) const {
  if (secret_.size() < shortest_secret) return text;
  for (auto at = text.find(secret_); at != std::string::npos; at = text.find(secret_, at))
    text.replace(at, secret_.size(), "***");
  return text;
}

Result<ApiKey> read_api_key(ChatProtocol protocol, const Endpoint& endpoint,
                            const std::filesystem::path& key_file) {
  auto key = key_file.empty() ? from_environment(protocol, endpoint) : from_file(key_file);
  if (key && !key->empty() && !endpoint.tls && !endpoint.is_loopback()) return clear_text(endpoint);
  return key;
}

}  // namespace roomgen
