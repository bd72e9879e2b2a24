#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "identity.h"
#include "library/shown_colors.h"
#include "outline.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// What is known of how an object looks: measured on its mesh, and said by who looked at it (the label of a
/// library's mesh) or made it (a recipe's kind). What the scene's description asked for is no evidence.
struct KnownLooks {
  Identity identity;
  std::vector<ShownColor> colors;
  /// Words of the names of materials that cover a seventh or more, with the roughness there; "glass" and
  /// "metal" also of what lets light through or is metallic.
  std::map<std::string, double> surfaces;
  std::set<std::string> clear;     ///< those of them that one sees through
  std::set<std::string> drawings;  ///< those of them that carry a texture
  double roughness = 0.8;          ///< mean over the surface
  Vec3 size = Vec3::Ones();        ///< metres
  Vec3 usual = Vec3::Ones();       ///< size of the kind, where it is known
  bool is_kind_known = true;
  Mount mount = Mount::floor;
  Outline outline = Outline::other;
  double steadiness = 0.0;         ///< degrees by which it may be tilted before it tips over
  Making making;                   ///< of what a recipe made
};
KnownLooks known_looks(const Object& object, const ModelTable& models);

struct AttributeVerdict {
  bool held = false;
  bool judged = true;  ///< false: nothing that is known could tell
  std::string reason;  ///< "mostly white", "no word of it is known"
};

/// Has the thing the attribute ("matte_black", "l-shaped", "pastel pink")? All words of it must
/// hold, the longest known phrases first (data/evaluate/attributes.json); a word that is in no
/// table holds if the label says it and cannot be judged otherwise; what is said of a part that it
/// has ("red curtain") needs to show on little of it; sizes in numbers ("160 cm wide") are those of
/// the box. docs/evaluation.md has the rules.
AttributeVerdict judge_attribute(const KnownLooks& looks, std::string_view attribute);

}  // namespace roomgen
