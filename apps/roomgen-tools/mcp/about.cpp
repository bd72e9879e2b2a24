#include "about.h"

#include <cassert>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>

extern "C" const unsigned char roomgen_mcp_tools[];
extern "C" const std::uint64_t roomgen_mcp_tools_size;

namespace roomgen::mcp {

Json about() {
  const std::string_view text(reinterpret_cast<const char*>(roomgen_mcp_tools), roomgen_mcp_tools_size);
  auto json = parse_json(text, "data/mcp/tools.json");
  assert(json);
  return *std::move(json);
}

}  // namespace roomgen::mcp
