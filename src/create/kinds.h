#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/shape/program.h"

namespace roomgen::create {

/// How a kind of thing is made by a recipe (docs/objects.md).
struct ShapeKind {
  std::string name;                ///< "nightstand"
  std::vector<std::string> names;  ///< what people call it besides, in the table of kinds
  std::string recipe;              ///< a file of data/shapes, without its ending
  shape::Values set;               ///< parameters that make it this kind
  std::map<std::string, std::vector<shape::Value>> vary;  ///< among which a seed chooses
  std::map<std::string, shape::Values> styles;            ///< what "industrial" sets
  Vec3 size = Vec3::Ones();                               ///< usual width, depth, height, metres
  Vec3 least = Vec3::Zero(), most = Vec3::Ones();         ///< that people would believe
  /// How the size follows from a count: `each` metres for one more than the usual size is for.
  struct Growth {
    double usual = 0.0;
    Vec3 each = Vec3::Zero();
  };
  std::map<std::string, Growth> growth;  ///< by parameter; "people": for whom it is
  Mount mount = Mount::floor;
  std::string main;  ///< the colour parameter that "a red ..." means; may be empty
};

/// Which kinds of a table can be made: data/shapes/kinds, and the recipes of data/shapes.
class ShapeKinds {
 public:
  /// The files say how kinds of the table are made. Table and recipes live as long as this; a recipe is
  /// parsed when it is first asked for.
  static Result<ShapeKinds> read(const KindTable& table,
                                 const std::vector<std::pair<std::string, Json>>& kind_files,
                                 const std::map<std::string, std::string_view>& recipes);
  /// Those that are compiled in.
  static const Result<ShapeKinds>& built_in();

  const std::map<std::string, ShapeKind, std::less<>>& all() const { return kinds_; }
  /// What is made for exactly this name, in the singular or the plural; null if there is nothing.
  const ShapeKind* find(std::string_view name) const;
  /// The kind whose name or other names share most with these words, the last word counting most;
  /// null when nothing is shared. Equal words give equal answers.
  const ShapeKind* nearest(std::string_view words) const;
  /// Several, nearest first.
  std::vector<const ShapeKind*> nearest(std::string_view words, std::size_t count) const;
  /// How many words from the front of these make the longest name of a kind; 0 if none does.
  std::size_t match(const std::vector<std::string>& words, std::size_t from,
                    const ShapeKind** kind) const;

  /// Null if there is none, or if it is no JSON. May be called by several threads.
  const Json* recipe(std::string_view name) const;
  /// For shape::instantiate().
  shape::RecipeSource recipes() const;
  /// What the recipe and all that it uses label their parts.
  std::set<std::string> labels(std::string_view recipe) const;

 private:
  const KindTable* table_ = nullptr;
  std::map<std::string, ShapeKind, std::less<>> kinds_;
  class Recipes;
  std::shared_ptr<Recipes> recipes_;
};

}  // namespace roomgen::create
