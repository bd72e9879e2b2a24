#pragma once

#include "roomgen/base/file.h"
#include "roomgen/lab/compose.h"
#include "roomgen/lab/optimise.h"
#include "roomgen/lab/program.h"

namespace roomgen::cli {

/// How a room came about by its program, without a clock: the same for equal input.
Json optimisation_json(const lab::Optimisation& result);

/// All files of a room that a program made: program.json, scene.json, optimise.json, scene.glb, ATTRIBUTION.md, and
/// pictures of so many pixels unless these are 0.
Status write_optimised_room(const OutputFolder& folder, const lab::ConstraintProgram& program,
                            const lab::Optimisation& result, const ModelTable& models, int pixels);

/// These of the round that was chosen, rounds.json and of each round what its author was shown.
Status write_composed_room(const OutputFolder& folder, const lab::Composition& composition,
                           const std::string& author, int pixels);

/// "12 things, 5 of 5 constraints held, 31 % of the floor covered"
std::string optimisation_headline(const lab::Optimisation& result);
/// What does not hold, a line each.
std::vector<std::string> unmet_lines(const lab::Optimisation& result);
/// The same of a composed room, with the measures that were asked for and what of the prompt is not so.
std::vector<std::string> composed_lines(const lab::Composition& composition);

}  // namespace roomgen::cli
