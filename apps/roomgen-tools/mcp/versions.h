#pragma once

#include <string>

#include "json_rpc.h"

/// The revisions of the Model Context Protocol that are spoken. Up to 2025-11-25 client and server agree on one
/// by `initialize`; from 2026-07-28 on every request says which it is made by, and results carry more.
namespace roomgen::mcp {

/// What `initialize` answers to a client that asks for this revision: the same, or the newest of that kind.
std::string agreed_version(const std::string& asked);

/// How a request is to be answered.
struct Manner {
  bool names_version = false;  ///< it says its revision itself
};

/// A fault when it names a revision that is not spoken.
std::variant<Manner, Fault> manner_of(const Message& request);

/// All that `server/discover` offers.
Json spoken_versions();

/// What a result carries besides when requests name their revision. `may_be_kept`: it is one of those that
/// clients may keep for a while; ours may change at any time.
Json in_manner(const Manner& manner, Json result, const Json& server_info, bool may_be_kept);

}  // namespace roomgen::mcp
