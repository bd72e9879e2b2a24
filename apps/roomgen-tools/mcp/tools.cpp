#include "tools.h"

#include <nlohmann/json.hpp>

#include "about.h"
#include "resources.h"

namespace roomgen::mcp {

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
