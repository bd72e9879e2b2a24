#pragma once

#include <functional>
#include <string>
#include <vector>

#include "roomgen/library/library.h"
#include "vocabulary.h"

namespace roomgen {

/// What words say of looks that can be held against what is known of a mesh.
struct WantedLooks {
  std::vector<std::string> colors;     ///< "navy blue", as AttributeWords has them
  std::vector<std::string> materials;  ///< "oak"
  std::string outline;                 ///< "round", "oval", "square", "rectangular"; empty: any
  std::vector<std::string> motifs;     ///< "whale": what a picture of it would show
  std::vector<std::string> prints;     ///< those that cloth would show
  std::vector<std::string> making;     ///< "six drawer", "tufted": what only who makes it can give it

  bool has_equal_sides() const { return outline == "round" || outline == "square"; }
};

/// Of a description: what is said of the thing itself, and which parts it shall have. Round legs
/// make no table round.
WantedLooks wanted_looks(std::string_view description);

/// Kinds whose cloth shows what is said of prints.
inline const std::vector<std::string> printed_cloths = {"rug", "pillow", "blanket", "curtain",
                                                        "towel"};

/// Has what was made all that was wanted of its making?
bool is_made_as_wanted(const Making& making, const WantedLooks& wanted);

/// In what does the asset look otherwise than wanted? Only what is known can disagree: its outline,
/// the parts that somebody saw, its largest colour, whether any main colour is one of the material,
/// the materials that its name and tags tell. What was measured counts before texts: meshes are
/// called after colours that they do not show. `says` tells whether the asset's own texts have a
/// word or one of its family; it is believed of materials.
Contradiction contradiction(const AssetInfo& asset, const WantedLooks& wanted, const Vocabulary& vocabulary,
                            const std::function<bool(const std::string&)>& says);

}  // namespace roomgen
