#include "tools.h"

#include <nlohmann/json.hpp>

#include "about.h"
#include "guides.h"
#include "resources.h"

namespace roomgen::mcp {

namespace {

const std::map<std::string, RoomTool*>& all_tools() {
  static const std::map<std::string, RoomTool*> tools = {
      {"read", read_wish},         {"plan", plan_room},         {"candidates", list_candidates},
      {"generate", generate_room}, {"compose", compose_room},   {"optimise", optimise_room},
      {"create", create_thing},    {"edit", edit_room},         {"undo", undo_edits},
      {"redo", redo_edits},        {"history", tell_history},   {"branch", go_to_branch},
      {"import", import_poses},    {"preview", preview_pose},   {"check", check_room},
      {"explain", explain_room},   {"review", review_room},     {"render", render_room},
      {"export", export_room},     {"rooms", list_rooms},       {"delete", delete_room}};
  return tools;
}

}  // namespace

Offer offer_of(Workplace& place, const std::string& version) {
  Offer offer;
  offer.about = about();
  offer.version = version;
  for (const auto& [name, tool] : all_tools())
    offer.tools[name] = [&place, tool](const ToolCall& call) { return tool(place, call); };
  offer.list_resources = [&place] {
    Json all = list_guides();
    for (auto& room : list_resources(place.root)) all.push_back(std::move(room));
    return all;
  };
  offer.read_resource = [&place](const std::string& uri) {
    auto guide = read_guide(uri);
    return guide ? Result<std::string>(*std::move(guide)) : read_resource(place.root, uri);
  };
  return offer;
}

}  // namespace roomgen::mcp
