#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "brief/brief.h"
#include "plan/inventory.h"
#include "roomgen/design/designer.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::design {

struct PlanReply {
  Plan plan;
  std::vector<std::string> repairs;  ///< what was understood otherwise than it was written
  std::string concept_text = {};     ///< what the room shall be like, in the model's words
};

/// What an answer about a whole room holds, before its things are in order. Draft i is mention i.
struct PlanParts {
  Room room;
  std::vector<plan::Draft> drafts;
  std::vector<PlanGroup> groups;
  std::vector<std::string> excluded;
  std::vector<std::string> repairs = {};
};

/// The same of an answer's JSON that is whole: what the request says of the room wins.
Result<PlanParts> read_plan_parts(const Json& json, const PlanRequest& request,
                                  const brief::Brief& brief, const KindTable& categories);

/// What a model answered about a whole room in the form of plan_schema(), or what comes near to it. The items are in the order of placement; `brief` is what the request's prompt says. What the
/// request says about the room wins. Errors
/// (invalid_input) say what is wrong in words meant for the model.
Result<PlanReply> read_plan_reply(std::string_view text, const PlanRequest& request,
                                  const brief::Brief& brief, const KindTable& categories);

/// Fails, in words meant for the model, when the things cover more than the whole floor: weak models
/// repeat themselves until they are stopped.
Status check_floor(const Plan& plan, const KindTable& categories);

}  // namespace roomgen::design
