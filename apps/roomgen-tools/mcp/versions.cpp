#include "versions.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace roomgen::mcp {

namespace {

// The newest last.
constexpr std::array<std::string_view, 4> agreed = {"2024-11-05", "2025-03-26", "2025-06-18", "2025-11-25"};
constexpr std::string_view named = "2026-07-28";

const char* const version_key = "io.modelcontextprotocol/protocolVersion";
const char* const server_key = "io.modelcontextprotocol/serverInfo";

}  // namespace

std::string agreed_version(const std::string& asked) {
  const bool is_spoken = std::find(agreed.begin(), agreed.end(), asked) != agreed.end();
  return is_spoken ? asked : std::string(agreed.back());
}

std::variant<Manner, Fault> manner_of(const Message& request) {
  const auto meta = request.params.find("_meta");
  if (meta == request.params.end() || !meta->is_object() || !meta->contains(version_key)) return Manner{};
  const Json& version = (*meta)[version_key];
  if (version == named) return Manner{true};
  return Fault{unsupported_version, "this revision of the protocol is not spoken here",
               {{"supported", spoken_versions()}, {"requested", version}}};
}

Json spoken_versions() {
  Json all(agreed);
  all.push_back(named);
  return all;
}

Json in_manner(const Manner& manner, Json result, const Json& server_info, bool may_be_kept) {
  if (!manner.names_version) return result;
  result["resultType"] = "complete";
  if (may_be_kept) {
    result["ttlMs"] = 0;
    result["cacheScope"] = "private";
  }
  result["_meta"] = {{server_key, server_info}};
  return result;
}

}  // namespace roomgen::mcp
