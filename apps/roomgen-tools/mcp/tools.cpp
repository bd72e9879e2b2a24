#include "tools.h"

#include <cassert>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>

#include "resources.h"

extern "C" const unsigned char roomgen_mcp_tools[];
extern "C" const std::uint64_t roomgen_mcp_tools_size;

namespace roomgen::mcp {

namespace {

/// data/mcp/tools.json, which is compiled in.
Json about() {
  const std::string_view text(reinterpret_cast<const char*>(roomgen_mcp_tools), roomgen_mcp_tools_size);
  auto json = parse_json(text, "data/mcp/tools.json");
  assert(json);
  return *std::move(json);
}

}  // namespace

Offer offer_of(Workplace& place, const std::string& version) {
  Offer offer;
  offer.about = about();
  offer.version = version;
  offer.tools = {{"plan", plan_tool(place)},       {"generate", generate_tool(place)},
                 {"compose", compose_tool(place)}, {"optimise", optimise_tool(place)}, {"edit", edit_tool(place)},
                 {"preview", preview_tool(place)}, {"check", check_tool(place)},       {"explain", explain_tool(place)},
                 {"undo", undo_tool(place)},       {"redo", redo_tool(place)},         {"history", history_tool(place)},
                 {"branch", branch_tool(place)},   {"import", import_tool(place)},
                 {"render", render_tool(place)},   {"export", export_tool(place)}};
  offer.list_resources = [&place] { return list_resources(place.root); };
  offer.read_resource = [&place](const std::string& uri) { return read_resource(place.root, uri); };
  return offer;
}

}  // namespace roomgen::mcp
