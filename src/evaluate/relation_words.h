#pragma once

#include <set>
#include <string>
#include <string_view>
#include <map>
#include <vector>

#include "roomgen/base/result.h"

namespace roomgen {

/// One function of SceneEval with its parameter: "side_of:left".
struct RelationFunction {
  std::string name;
  std::string parameter;
  bool reversed = false;  ///< the anchor is judged against the target

  bool operator==(const RelationFunction&) const = default;
};

/// Of the alternatives one must hold; of an alternative every function.
using RelationMeaning = std::vector<std::vector<RelationFunction>>;

/// What annotators' words mean (data/evaluate/relations.json), where SceneEval asks a language model.
class RelationWords {
 public:
  static Result<RelationWords> parse(std::string_view text, const std::string& source);
  static const RelationWords& built_in();

  /// Empty if the word is unknown. `anchor` is a category: what is on a shelf may be in it.
  RelationMeaning between_objects(std::string_view word, std::string_view anchor) const;
  /// `part` is wall, door, window, ceiling or room; any other word is a kind of room ("kitchen").
  RelationMeaning to_room(std::string_view word, std::string_view part) const;

 private:
  using Meanings = std::map<std::string, RelationMeaning, std::less<>>;
  Meanings objects_;
  std::map<std::string, Meanings, std::less<>> room_;
  std::set<std::string, std::less<>> shelves_;
};

}  // namespace roomgen
