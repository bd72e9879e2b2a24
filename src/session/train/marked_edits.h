#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "edit_roles.h"
#include "role_features.h"

namespace roomgen {

/// A sentence of data/language/edits as it is learned from.
struct MarkedEdit {
  EditText text;
  std::vector<WordSigns> signs;
  std::vector<EditRole> roles;  ///< of the tokens
  struct Order {
    SpokenOrder order;
    EditDeed deed = EditDeed::move;
    std::string previous;       ///< the deed before, as deed_features() has it
    std::optional<std::size_t> place;  ///< of place_names
  };
  std::vector<Order> orders;
};

using MarkedScenes = std::map<std::string, Scene, std::less<>>;

/// The scenes of which the sentences speak, by what stands in them; throws std::runtime_error on what is none.
MarkedScenes read_marked_scenes(const std::string& path);
/// Throws std::runtime_error with the line of what it cannot read. The scenes must outlive the result.
std::vector<MarkedEdit> read_marked_edits(const std::string& path, const MarkedScenes& scenes);

}  // namespace roomgen
