#pragma once

#include <functional>
#include <string>
#include <vector>

#include "roomgen/library/library.h"
#include "vocabulary.h"

namespace roomgen {

/// What words say of looks that can be held against what is known of a mesh.
struct WantedLooks {
  enum class Outline { any, round, angular };
  std::vector<std::string> colors;     ///< "navy blue", as AttributeWords has them
  std::vector<std::string> materials;  ///< "oak"
  Outline outline = Outline::any;
  std::vector<std::string> making;     ///< "six drawer", "tufted": what only who makes it can give it
};

/// Of single words in lower case, in the order in which they were said.
WantedLooks wanted_looks(const std::vector<std::string>& words);

/// Has what was made all that was wanted of its making?
bool is_made_as_wanted(const Making& making, const WantedLooks& wanted);

/// In what does the asset look otherwise than wanted? Only what is known can disagree: its outline, its largest
/// colour, whether any main colour is one of the material, the materials that its name and tags tell.
/// What was measured counts before texts: meshes are called after colours that they do not show. `says`
/// tells whether the asset's own texts have a word or one of its family; it is believed of materials.
Contradiction contradiction(const AssetInfo& asset, const WantedLooks& wanted, const Vocabulary& vocabulary,
                            const std::function<bool(const std::string&)>& says);

/// Is a side so far from the wanted box that whoever named the size would not accept it? What has no
/// front may stand the other way round.
bool contradicts_size(const AssetInfo& asset, const Vec3& wanted);

}  // namespace roomgen
