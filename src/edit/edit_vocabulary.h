#pragma once

#include <map>
#include <string>

#include "brief/prompt_words.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/vec.h"

namespace roomgen {

/// "twice as wide": which sides of a thing change, and how much.
struct Growth {
  std::string side;  ///< all, long (the longer of width and depth), width, depth, height
  double factor = 1.0;
};

/// The words of data/edits.json; docs/word-lists.md explains the lists.
struct EditVocabulary {
  template <typename T>
  using Map = std::map<std::string, T, std::less<>>;
  using Set = brief::WordSet;

  Map<std::string> verbs;  ///< "get rid of": "remove"
  Set openers, closers, explanations, pronouns, just_added, all, everything, except, more, nearest, away, closer, to,
      faces, where_they_are, back, words_of_looks, stays, emphasis, hedges, modals, goes_away, properties, refused,
      auxiliaries, requests, reasons, substitutes, whole_room, whole_dwelling, along, farthest, being, not_being, presently, place_of,
      there, at_parts, space, around_space, gap_to, one_each, each_corner, possible, middles, besides, each_other,
      side_by_side, corrections, questions, welcome, own, suffices, only_these, likewise, shapes, like_it, existing,
      something, vice_versa, particles, made_of, unneeded, facing_away, up_to_ceiling, courtesies, short_is_before, too,
      in_the_way_of, wrong_way, further_on, others, denials, wishes, apart, centred, other_side, betters, tellers, told_how, told_deeds, negations;
  Map<Vec2> sides, directions;   ///< in the scene's frame, as pictures from above show it
  Map<Vec2> side_tails;          ///< behind a noun: "on the left"
  Map<Vec2> sides_of_things, parts_of_things;  ///< in a thing's frame, left as one sees it from in front of it
  Map<double> own_ways;          ///< 1 to where the front looks
  Map<std::string> rewordings;   ///< "the dining set": as it is said more plainly
  Map<double> lifts;             ///< verbs that say which way: 1 up
  Map<double> sizes;             ///< "taller": the axis from 1, 2 for width, 3 for height; below 0: the least
  Map<double> heights;           ///< 1 up
  Map<double> amounts;           ///< metres
  Map<double> wall_ways;         ///< 1 outwards
  Map<double> shares;            ///< of one: "a quarter"
  Map<double> turns;             ///< degrees
  Map<double> turn_directions;   ///< 1 counter-clockwise
  Map<Growth> growth, verbs_of_size;
  Map<double> degrees;           ///< "much": the power of the usual factor
  Map<double> counts;            ///< "a pair of"
  Map<double> multiples;         ///< "twice"
  Map<std::string> contractions, clitics;  ///< as they are written out: "'re": "are"
  Map<std::string> measured;     ///< "deep": the side that it measures
  Map<std::string> places;       ///< other words for those of data/words.json
  Map<std::string> room_parts;   ///< "floors": "floor"
};

const Result<EditVocabulary>& edit_vocabulary();

using brief::longest_in;

}  // namespace roomgen
