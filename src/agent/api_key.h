#pragma once

#include <filesystem>
#include <string>

#include "endpoint.h"
#include "roomgen/agent/http_model.h"
#include "roomgen/base/result.h"

namespace roomgen {

/// The secret that an endpoint knows its user by; empty when it wants none. Not printable by
/// accident: whoever needs the text asks for it by name.
class ApiKey {
 public:
  ApiKey() = default;
  explicit ApiKey(std::string secret) : secret_(std::move(secret)) {}

  bool empty() const { return secret_.empty(); }
  const std::string& reveal() const { return secret_; }
  /// `text` with "***" wherever the key stands. Words shorter than eight bytes, as local servers
  /// are given for form's sake, are no secrets and stay.
  std::string scrub(std::string text) const;

 private:
  std::string secret_;
};

/// The key for an endpoint, from the file if one is named, else from the environment (http_model.h
/// says which variables). Fails when there is none and the endpoint is not on this machine, when
/// others may read the file, and when the key cannot be one.
Result<ApiKey> read_api_key(ChatProtocol protocol, const Endpoint& endpoint,
                            const std::filesystem::path& key_file);

}  // namespace roomgen
