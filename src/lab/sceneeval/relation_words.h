#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "part_of_room.h"
#include "roomgen/base/result.h"

namespace roomgen::lab {

/// One function of SceneEval, or of ours where it has none, with its parameter: "side_of:left".
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
  /// `part` is wall, door, window, ceiling, floor or room; any other word is a kind of room
  /// ("kitchen"). A room has parts as well: "northern_half".
  RelationMeaning to_room(std::string_view word, std::string_view part) const;
  /// Nothing for a word that names no part of a room.
  std::optional<PartOfRoom> part_of_room(std::string_view word) const;

 private:
  using Meanings = std::map<std::string, RelationMeaning, std::less<>>;
  Meanings objects_;
  std::map<std::string, Meanings, std::less<>> room_;
  std::set<std::string, std::less<>> shelves_;
  std::map<std::string, std::vector<RoomSide>, std::less<>> sides_;
  std::map<std::string, double, std::less<>> shares_;
};

}  // namespace roomgen::lab
