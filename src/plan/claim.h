#pragma once

#include <string>
#include <vector>

#include "brief/brief.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/plan.h"

namespace roomgen::plan {

/// Things of a mention that a plan lacks.
struct Forgotten {
  std::size_t mention = 0;  ///< index into Brief::mentions
  int lacking = 0;
};

/// A plan that somebody else made, held against what the prompt asks for.
struct Claim {
  /// Of each of Plan::items: the mention that asks for it, or Demand::none.
  std::vector<std::size_t> mention_of;
  std::vector<Forgotten> forgotten;
};

/// Gives the items of a plan to the mentions of the prompt: those of the same kind first, then those
/// of which one's kind is of the other's, then things of the same noun and about the same size.
Claim claim(const Plan& plan, const brief::Brief& brief, const KindTable& table);

/// The clauses of a prompt, with their ids, before anybody has planned: their things have no ids yet.
std::vector<Requirement> clauses_of(const PlanRequest& request, const brief::Brief& brief,
                                    const KindTable& table);

/// What is wrong, in words meant for who made the plan, by the requirements that it does not meet:
/// "r3: a wardrobe: 0 of 1; r7: 2 red lamp: 1 of 2". Empty if nothing is.
std::string objection(const PlanRequest& request, const Claim& claim, const brief::Brief& brief,
                      const Plan& plan);

/// Adds what was forgotten, and makes the prompt's clauses the requirements of the plan.
void fulfil(const PlanRequest& request, const Claim& claim, const brief::Brief& brief,
            const KindTable& table, Plan& plan);

}  // namespace roomgen::plan
