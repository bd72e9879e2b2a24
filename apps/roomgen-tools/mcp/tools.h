#pragma once

#include "workplace.h"

/// The tools of data/mcp/tools.json, a function each.
namespace roomgen::mcp {

Tool plan_tool(Workplace& place);
Tool generate_tool(Workplace& place);
Tool compose_tool(Workplace& place);
Tool optimise_tool(Workplace& place);
Tool edit_tool(Workplace& place);
Tool undo_tool(Workplace& place);
Tool redo_tool(Workplace& place);
Tool history_tool(Workplace& place);
Tool branch_tool(Workplace& place);
Tool import_tool(Workplace& place);
Tool preview_tool(Workplace& place);
Tool check_tool(Workplace& place);
Tool explain_tool(Workplace& place);
Tool render_tool(Workplace& place);
Tool export_tool(Workplace& place);

/// All of them with the resources: what a server offers. `place` must outlive it.
Offer offer_of(Workplace& place, const std::string& version);

}  // namespace roomgen::mcp
