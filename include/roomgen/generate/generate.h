#pragma once

#include "roomgen/generate/generation.h"
#include "roomgen/generate/room_builder.h"
#include "roomgen/scene/dwelling.h"

namespace roomgen {

/// Furnishes a room step by step (RoomBuilder): for each planned object retrieve an asset, ask the designer,
/// propose, score, fuse, place; when it does not fit, the next asset, then the designer again with the
/// reason, then a repair, then it is left out with the reason. A last improvement wins back what was lost.
/// One object that fails never costs another its place. When cancelled, or when the designer may ask no more
/// (Error::Kind::limit), what is placed so far is returned and the scene is marked incomplete.
Result<Generation> generate(const Plan& plan, Designer& designer, const AssetLibrary& library,
                            const KindTable& categories, const BuildOptions& options = {});

/// Furnishes the rooms of a dwelling one after the other into one scene; events count through all of them.
/// What was stopped in one room is stopped in those after it.
Result<Generation> generate(const DwellingPlan& plan, Designer& designer,
                            const AssetLibrary& library, const KindTable& categories,
                            const BuildOptions& options = {});

}  // namespace roomgen
