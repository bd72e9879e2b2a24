#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/kinds/kind_table.h"
#include "shape/expression.h"

namespace roomgen::composition {

using shape::Value;
using shape::Values;
using Formula = shape::Expression;

/// How a part lies to the part that it belongs to (docs/groups.md).
enum class Where {
  at,      ///< its centre in the other's frame
  beside,  ///< in a row along a side of the other
  around,  ///< seats on all sides of the other
  before,  ///< on the other, at the place of each of those who sit at it
};

/// Which way the front of a part looks, in the frame of the part that it belongs to.
enum class Facing { same, opposite, to, away };

/// Copies of a part about the place where one would be.
struct Repeat {
  bool is_arc = false;
  Formula rows, columns, across, along, stagger;  ///< of a grid; metres from middle to middle
  Formula number;                                 ///< at most so many
  Formula radius, from, to;                       ///< of an arc; degrees, 0 to the right
};

/// One of the things of a composition, or a composition within it.
struct Part {
  std::string name;  ///< by which others and plans refer to it
  std::string kind;  ///< of thing; empty: it is a composition
  std::string composition;
  std::map<std::string, Formula, std::less<>> with;  ///< parameters of that composition
  std::string description;
  std::array<std::optional<Formula>, 3> size;  ///< else the usual one of its kind
  std::optional<Mount> mount;                  ///< else the usual one
  bool varied = false;

  Where where = Where::at;
  std::string of;           ///< a part; empty for the anchor
  std::string seat;         ///< for Where::before
  bool on = false;          ///< it stands on that part
  bool first_only = false;  ///< of that part's copies
  std::vector<Side> sides;
  enum class Align { middle, back, front } align = Align::middle;
  std::optional<Formula> count, gap, pitch, shift, x, y, yaw, height, when;
  std::optional<Facing> facing;
  std::optional<Repeat> repeat;
  int spare = 0;  ///< what has a lower one is left out first; 0: never
};

/// A number or a word that a composition is set by.
struct Parameter {
  std::string name;
  Value value = 0.0;  ///< unless told otherwise
  double least = 0.0, most = 0.0;
  std::vector<Formula> others;       ///< further values to try where the first does not fit
  bool shrinks = false;              ///< down to the least, where there is no room for more
  std::vector<std::string> choices;  ///< of a word
};

/// Things that belong together, in the frame of the first of them, the anchor.
struct Composition {
  std::string name, source;
  std::vector<std::string> uses;  ///< "dining at home"
  std::string family;             ///< of the built-in ones: the name of its file
  std::vector<Parameter> parameters;
  std::vector<Part> parts;
  bool mirrors = false;  ///< its mirror image is another
  std::string
      wants;  ///< its arrangement, as data/arrangements.json has those of kinds; JSON, may be empty
};

/// By name; those that a plan brings along go before the built-in ones.
using Compositions = std::map<std::string, Composition, std::less<>>;

inline constexpr std::size_t most_parts = 60, most_members = 400;
inline constexpr int deepest_nesting = 5;

/// One composition of data/compositions or of a plan. Located errors for what is unknown or not of
/// its form.
Result<Composition> read_composition(const Json& json, const std::string& name,
                                     const std::string& source);
/// data/compositions.
const Result<Compositions>& built_in_compositions();

}  // namespace roomgen::composition
