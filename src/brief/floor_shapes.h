#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/random.h"
#include "room_kinds.h"
#include "roomgen/base/result.h"
#include "shape/expression.h"

namespace roomgen::brief {

/// Numbers that differ from room to room, by name.
using Draws = std::map<std::string, Range, std::less<>>;

/// x and y as formulas of what is drawn.
using FormulaPoint = std::array<shape::Expression, 2>;

/// The outline of a floor in a box from (0, 0) to (1, 1), counter-clockwise.
struct OutlineKind {
  Draws draws;
  std::vector<FormulaPoint> corners;
  int sides = 0;             ///< of a regular polygon, instead of corners
  std::vector<int> without;  ///< of its corners
  double area = 1.0;         ///< factor on the area of a room whose size is chosen: nooks cost floor
};

/// A part of an outline that breaks one wall or one corner; metres.
struct FeatureKind {
  Draws draws;
  double least = 0.0;                ///< length of a wall that can have it
  std::vector<FormulaPoint> along;   ///< new corners: along the wall (m is its middle), outward
  std::vector<std::size_t> glazed;   ///< new walls that are windows, from 0
  std::vector<shape::Expression> cut;  ///< instead: off the walls before and behind a corner
};

/// data/floor-shapes.json (docs/rooms.md).
struct FloorShapes {
  std::map<std::string, OutlineKind, std::less<>> outlines;
  std::map<std::string, FeatureKind, std::less<>> features;
  std::map<std::string, std::string, std::less<>> outline_names, feature_names;
  std::map<std::string, Range, std::less<>> proportions;  ///< longer side to shorter, by word
};

Result<FloorShapes> parse_floor_shapes(std::string_view text, const std::string& source);
/// The knowledge compiled into the library.
const Result<FloorShapes>& built_in_floor_shapes();

/// One of each, to evaluate formulas with.
shape::Scope drawn(const Draws& draws, Random& random);

}  // namespace roomgen::brief
