#pragma once

#include <memory>

#include "room_shell.h"

namespace roomgen::detail {

/// The model of an opening's asset, if it has one that can be shown whole in a wall of this height.
std::shared_ptr<const Model> joinery_to_show(const Opening& opening, double height,
                                             const ShellOptions& options, const ModelTable& models);

/// The model in its hole, in room coordinates: as wide and high as the hole, its part in the wall
/// as deep as the wall. Its front looks into the room, or out of it for a door that opens outward.
Model fitted_joinery(const Room& room, const Opening& opening, const Model& model);

}  // namespace roomgen::detail
