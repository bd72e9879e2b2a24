#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomgen/create/create.h"
#include "roomgen/create/maker.h"
#include "roomgen/export/exporter.h"
#include "roomgen/geometry/model.h"

namespace roomgen::cli {

/// An object with all that commands say about it.
struct Made {
  shape::Program program;
  shape::Shape shape;
  create::Soundness soundness;
  bool judged = false;  ///< from words: it was validated, or measured at least
  bool by_rules = false;  ///< they stepped in for a model
  std::vector<std::string> repairs, notes;
};

/// What a sentence or a program makes: objects, the main one first, and all of them as one model.
struct MadeAll {
  std::vector<Made> objects;
  Model model;
  std::vector<std::string> notes;  ///< about how they stand together
  std::optional<create::Scores> scores;
};

/// The objects of a sentence that passed; several are set out by the solver.
Result<MadeAll> made_of(create::Creation creation, std::uint64_t seed);
Made made_of(create::CreatedObject object);

/// What --json prints of an object.
Json object_json(const Made& made);
/// The same of all.
Json objects_json(const MadeAll& all);

}  // namespace roomgen::cli
