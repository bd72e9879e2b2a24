#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/scene/object.h"

namespace roomgen {

/// What an object of a scene is known to be, from what made it: the label of a library's mesh or the
/// kind of a recipe. What the scene's description asked for is no evidence.
struct Identity {
  std::string kind;             ///< "dining chair"
  std::set<std::string> words;  ///< of the kind and of the mesh's label, in the singular
  std::set<std::string> asked;  ///< of what it was made or chosen for: they name, they prove nothing
  std::string basis;            ///< "label of Scopia/chair", "recipe kind"
};

/// Decides whether an object is what a category names (docs/evaluation.md).
class KindNames {
 public:
  /// From the vocabulary, the categories, the kinds of shapes and the labels that are compiled in.
  static const KindNames& built_in();

  Identity identify(const Object& object) const;
  /// How well a thing of this identity is what the category names; 0 is not at all. 5: the same
  /// name, 4: another name of the same kind, 3: a kind of it, 2: it by all but words that say how a
  /// thing is ("wooden desk") or for which it was chosen (a plate for "sushi plate"), or merely without the rest of its name (a lamp for "floor lamp"), 1: a compound of it ("lava lamp" for "lamp").
  int rank(const Identity& identity, std::string_view category) const;

  /// Which objects are which category, by index. An object is one category at most: the one of the
  /// highest rank; among equals the one whose words it was chosen for (a buffet of a sideboard), then
  /// the one that it was placed as, else the first.
  std::map<std::string, std::vector<std::size_t>> match(
      const std::vector<Object>& objects, const std::vector<std::string>& categories) const;

 private:
  KindNames();
  bool is_known(const std::string& category) const;
  bool same(const std::string& kind, const std::string& category) const;
  bool descends(const std::string& kind, const std::string& category) const;

  std::map<std::string, std::set<std::string>> shape_kinds_of_;  ///< by any name, their names
  std::map<std::string, std::string> categories_of_;  ///< any spelling to a name of the category table
  std::map<std::string, std::string> labels_;         ///< by "library/id"
};

}  // namespace roomgen
