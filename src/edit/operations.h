#pragma once

#include "draft.h"
#include "roomgen/edit/operation.h"

namespace roomgen {

/// Carries an operation out on the draft, or fails and says why; then the draft is of no more use. The ledger
/// is not looked at (edited_ledger.h), but what the operation asks for is in Draft::wishes.
Status carry_out(Draft& draft, const edit::Operation& operation);

// One for each.
Status carry_out(Draft& draft, const edit::Add& add);
Status carry_out(Draft& draft, const edit::Remove& remove);
Status carry_out(Draft& draft, const edit::Move& move);
Status carry_out(Draft& draft, const edit::Put& put);
Status carry_out(Draft& draft, const edit::Shift& shift);
Status carry_out(Draft& draft, const edit::Turn& turn);
Status carry_out(Draft& draft, const edit::Face& face);
Status carry_out(Draft& draft, const edit::Swap& swap);
Status carry_out(Draft& draft, const edit::Replace& replace);
Status carry_out(Draft& draft, const edit::Resize& resize);
Status carry_out(Draft& draft, const edit::Recolor& recolor);
Status carry_out(Draft& draft, const edit::Lock& lock);
Status carry_out(Draft& draft, const edit::Cover& cover);
Status carry_out(Draft& draft, const edit::Light& light);
Status carry_out(Draft& draft, const edit::Rearrange& rearrange);
Status carry_out(Draft& draft, const edit::Arrange& arrange);
Status carry_out(Draft& draft, const edit::Reform& reform);
Status carry_out(Draft& draft, const edit::Reshape& reshape);
Status carry_out(Draft& draft, const edit::Open& open);
Status carry_out(Draft& draft, const edit::Refit& refit);
Status carry_out(Draft& draft, const edit::Close& close);
Status carry_out(Draft& draft, const edit::Revert& revert);

/// The kind that is brought: what goes onto other things may be another sort of it, a lamp on a table a table
/// lamp.
const Kind& kind_to_add(const KindTable& kinds, const edit::Add& add);
/// A stand-in, or nothing that is known: plans and scenes call such a thing as it was called.
bool is_of_no_kind(const Kind& kind);
/// The item gets what its program builds as its asset.
Status build_as_written(Draft& draft, const std::string& program, PlanItem& item);
/// The id that the next new thing of a category gets in this scene, after `further` others.
std::string next_id(const Scene& scene, const std::string& category, int further = 0);

/// A clause of the ledger that an edit asks for.
Requirement wish_for(const Object& object, const std::string& clause, Requirement::Kind kind);
/// "lamp-0 next to bed-0", for each of the relations.
void wish_relations(Draft& draft, const Object& object, const std::vector<Relation>& relations);

/// The targets are things of the scene or parts of the room; not_found, naming the one that is not.
Status check_targets(const Draft& draft, const std::string& room, const std::vector<Relation>& relations);

}  // namespace roomgen
