#pragma once

#include <optional>
#include <span>
#include <string>

#include "prompt_words.h"
#include "tokens.h"

namespace roomgen::brief {

/// Part of a room that a placement can name.
enum class Place { window, door, corner, wall, middle, region, room, floor, ceiling };

/// "the left wall", "a corner of the room", "the two windows", "the northern half"
struct PlacePhrase {
  Place place = Place::room;
  int wall = -1;          ///< which, of a rectangle; -1: not said
  int side = -1;          ///< the wall that a region lies at: "the left"
  std::string region = {};  ///< "north-half"; of a corner "north-east-quarter"
  bool opposite = false;  ///< "the opposite wall"
  std::string length_of_wall = {};  ///< "long", "short": which walls of a rectangle; empty: not said
  bool centered = false;  ///< "the middle of the back wall"
  std::size_t length = 0;
};

/// Reads articles, qualifiers and a part of a room from `at`, and "of the room" after it.
std::optional<PlacePhrase> read_place(std::span<const Token> tokens, std::size_t at,
                                      const Vocabulary& words);

/// How plans name the wall that a place tells of: "wall-2", "long-wall"; empty if it tells of none. Of "the middle of the
/// wall" a long one is meant.
std::string wall_named(const PlacePhrase& place);

}  // namespace roomgen::brief
