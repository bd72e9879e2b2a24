#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formation.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/vec.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/relation.h"
#include "tokens.h"

namespace roomgen::brief {

using WordSet = std::set<std::string, std::less<>>;

/// What "next to" and its like mean.
struct Placement {
  std::vector<RelationKind> relations;
  bool flank = false;     ///< one on each side
  bool pronoun = false;   ///< names its target itself: "to its left"
  bool adverb = false;    ///< may do without a target: "a chair nearby"
  bool centered = false;  ///< of a room: in its middle
  bool hanging = false;   ///< of lamps: from the ceiling
  bool mutual = false;    ///< of things to each other: "side by side"
  bool seated = false;    ///< of tables: one sits at them so, and what stands on things is on them: "at"
  bool paired = false;    ///< of several, by twos: "in pairs"
  std::string owner = {};   ///< what alone has such a part: "at the foot" is a bed's
  bool inverse = false;   ///< said of the target: "a sofa flanked by two lamps"
};

/// The words of data/words.json.
struct Vocabulary {
  std::map<std::string, int, std::less<>> numbers, people, walls;
  std::map<std::string, Vec3, std::less<>> sizes;
  std::map<std::string, std::string, std::less<>> room_parts, shares;
  std::map<std::string, int, std::less<>> spreads;  ///< "all over": at least so many
  std::map<std::string, std::string, std::less<>> wall_lengths;  ///< "longer": long
  std::map<std::string, std::string, std::less<>> limits;  ///< "nothing else", "nothing but": else, but, only, nothing
  std::map<std::string, Placement, std::less<>> placements;
  WordSet pairs;     ///< one thing though a plural: "headphones", "a pair of scissors"
  WordSet diagonals;  ///< kinds whose one length is that of a diagonal: a television of 65 inches
  WordSet manners;   ///< how things stand or lie where nothing plans or judges it: "leaning", "stacked"
  WordSet verbs;     ///< finite: what stands before begins a clause
  WordSet courtesies;  ///< "hey", "please": of no consequence
  WordSet height_beginnings, height_endings;  ///< around a length: "at" 1.8 m, 1.5 m "above the floor"
  WordSet distances;  ///< behind a length: "1.5 m above the floor" is where a thing is, and no size of it
  WordSet tops;      ///< "the countertop": of what was spoken of
  WordSet portions;  ///< "the edge of the bathtub", "the sofa cushion": stand for the whole
  WordSet groups;    ///< "two rows of desks": how often as many
  WordSet areas;     ///< "corner", "nook", "zone": a part of the room that has things of its own
  WordSet rows;      ///< of the groups those that are lines: how things stand
  WordSet palette_frames;  ///< around colours that are said of no thing: "accents", "shades"
  WordSet further;   ///< "extra towels": besides those spoken of
  WordSet asking;    ///< "create", "add": verbs that only ask for something
  WordSet exceptions;  ///< "except", "but"
  std::map<std::string, FormationWord, std::less<>> round_formations;  ///< "circle", "half circle"
  WordSet anything;  ///< "furniture", "things": whatever there is
  WordSet full_heights;  ///< "floor to ceiling": as high as the room
  WordSet built_in;  ///< what is so is no thing of its own
  WordSet vague, definite, negations, measured, stops, parts, no_things, materials,
      people_words, room_words, generic_rooms;
};

Result<Vocabulary> parse_vocabulary(std::string_view text, const std::string& source);
const Result<Vocabulary>& built_in_vocabulary();

/// How many tokens from `at` on are the longest phrase of the set; 0 if none is.
std::size_t longest_in(const WordSet& phrases, std::span<const Token> tokens, std::size_t at);

/// A run of tokens that means something.
template <typename T>
struct Match {
  const T* value = nullptr;
  std::size_t length = 0;

  explicit operator bool() const { return value != nullptr; }
};

/// The longest run of words from `at` that is a key of the map.
template <typename T>
Match<T> longest(const std::map<std::string, T, std::less<>>& map, std::span<const Token> tokens,
                 std::size_t at, std::size_t most = 5) {
  Match<T> best;
  std::string phrase;
  for (std::size_t n = 0; n < most && at + n < tokens.size(); ++n) {
    const Token& token = tokens[at + n];
    if (token.kind != Token::Kind::word && token.kind != Token::Kind::number) break;
    phrase += (n ? " " : "") + token.text;
    if (const auto found = map.find(phrase); found != map.end()) best = {&found->second, n + 1};
  }
  return best;
}

}  // namespace roomgen::brief
