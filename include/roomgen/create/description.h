#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomgen/base/json_fwd.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/vec.h"

/// Objects built from words (papers: primitives, section 3): a classifier, a decomposer, a generator
/// and a validator.
namespace roomgen::create {

/// How a part runs (papers: primitives, section 3.3).
enum class Course { straight, arc, s_curve, taper, spiral, wave };
enum class Strength { gentle, moderate, pronounced };

/// Where a part stands on a thing whose recipe does not know it (data/create/parts.json).
enum class Place {
  foot,     ///< carries the whole, one in the middle or several around
  base,     ///< slabs below everything, each upon the other
  deck,     ///< boards, one above the other
  column,   ///< uprights in the middle
  upright,  ///< uprights at the sides
  across,   ///< bars from side to side
  stack,    ///< piled up in the middle
  helix,    ///< winding up around the column
  radial,   ///< outward from the column on all sides
  wheel,    ///< outward from a hub in the front, as the blades of a mill
  around,   ///< in a ring on the floor
  front, side, back, top,
  hang,     ///< below a bar
};

/// How copies of one part differ, each from the one before (below).
struct Series {
  double scale = 1.0;  ///< of the width and depth
  double turn = 0.0;   ///< about the vertical axis, radians

  bool operator==(const Series&) const = default;
};

/// A part as a sentence asks for it; what it does not say is empty.
struct PartWish {
  std::string label;               ///< in the singular, as shape programs label parts: "leg"
  std::optional<int> count;        ///< 0: "without armrests"
  bool one = false;                ///< "a bucket": no number, but no more than one where that is free
  std::string shape;               ///< "round", "square"
  std::string construction;        ///< "turned", "hairpin", "slatted"
  std::string material;            ///< "brass"
  std::string color;               ///< "white"
  std::optional<double> lean;      ///< degrees outward: "slanted"
  std::optional<Course> course;
  Strength strength = Strength::moderate;
  std::string direction;           ///< of the course: "vertical", "outward"
  std::optional<Vec3> size;        ///< metres
  Vec3 scale = Vec3::Ones();       ///< against the usual: "thick", "long"
  std::vector<std::string> touches;  ///< labels of the parts it is joined to
  std::optional<Place> place;        ///< "on three stones": another place than the part's usual one
  Series series;
};

/// What a sentence says about one object.
struct Description {
  std::string prompt;              ///< the words about this object
  std::string noun;                ///< what it is called: "bar stool"
  std::string kind;                ///< the kind of data/shapes/kinds that will do; empty: none is near
  bool approximate = false;        ///< the kind is only the nearest one
  int count = 1;                   ///< how many of it
  std::string style;               ///< "industrial"
  std::string material, color;     ///< of the whole
  std::optional<Vec3> size;        ///< width, depth, height in metres, where said; NaN: not said
  Vec3 scale = Vec3::Ones();       ///< "large", "low", against the usual
  std::vector<PartWish> parts;
  bool contradicted = false;       ///< two numbers were said of one part, or two lengths of one side
  std::string relation;            ///< to the first object of the sentence: "on", "around"; may be empty
};

/// {"object", "kind", "count", "style", "material", "color", "size_cm", "parts": [{"label", ...}]}
Json to_json(const Description& description);
Result<Description> description_from_json(const Json& json, const std::string& source);

}  // namespace roomgen::create
