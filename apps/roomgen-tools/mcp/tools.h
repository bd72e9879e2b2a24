#pragma once

#include "workplace.h"

/// The tools of data/mcp/tools.json, a function each.
namespace roomgen::mcp {

using RoomTool = Result<ToolAnswer>(Workplace& place, const ToolCall& call);

RoomTool read_wish, plan_room, list_candidates, generate_room, compose_room, optimise_room;
RoomTool create_thing, edit_room, undo_edits, redo_edits, tell_history, go_to_branch, import_poses;
RoomTool preview_pose, check_room, explain_room, review_room, render_room, export_room;
RoomTool list_rooms, delete_room;

/// All of them with the resources: what a server offers. `place` must outlive it.
Offer offer_of(Workplace& place, const std::string& version);

}  // namespace roomgen::mcp
