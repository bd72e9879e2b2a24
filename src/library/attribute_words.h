#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"
#include "roomgen/scene/object.h"

namespace roomgen {

/// A closed interval.
struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  bool contains(double value) const { return value >= low && value <= high; }
};

/// What is measured of a thing's size against the usual one of its kind or in itself.
enum class SizeMeasure {
  width, depth, height, longest,  ///< metres; longest: of the three
  usual_width, usual_depth, usual_height, usual_volume,  ///< as a multiple of the usual one
  slimness,   ///< height over the longer side of the footprint
  elongation,  ///< longer side of the footprint over the shorter
  steadiness   ///< degrees by which it may be tilted before it tips over
};
std::optional<SizeMeasure> parse_size_measure(std::string_view text);

/// What a word says of a thing's looks (data/evaluate/attributes.json). Members that are empty say
/// nothing; `kinds` and `said` are other ways to be so, all else must hold together.
struct AttributeMeaning {
  /// Names of shown_colors.h, of which one must be shown; with `materials`, those that the material can
  /// have by nature.
  std::vector<std::string> colors;
  std::optional<Interval> lightness;      ///< of the shown colour, in [0, 1]
  std::optional<int> least_colors, most_colors;  ///< so many must, no more may be shown
  std::vector<std::string> materials;  ///< words that name this material
  std::string family;                  ///< of an oak: "wood"
  std::vector<std::string> outlines;   ///< round, oval, square, rectangular, l-shaped
  std::vector<std::map<SizeMeasure, Interval>> sizes;  ///< alternatives; of one all must hold
  std::optional<Interval> roughness;      ///< of the surface (with `materials`: of that one), in [0, 1]
  std::vector<std::string> drawings;   ///< names of this pattern
  std::vector<Mount> mounts;           ///< of which it is put up in one
  std::vector<std::string> kinds;      ///< that are so by nature: a pillow is soft
  std::vector<std::string> kinds_of_its_color;  ///< that are of this material when they have its colour: a
                                                ///< grey fridge is of steel, a brown desk of wood
  std::vector<std::string> said;       ///< words of a label that say the same
  /// How many parts of each name who made it gave it; alternatives, of one all must hold.
  std::vector<std::map<std::string, Interval>> parts;
  std::vector<std::string> ways;       ///< choices of recipes, of which one must be made: "spindles"

  /// Is it a colour or a material?
  bool of_looks() const { return !colors.empty() || !materials.empty(); }

  /// Does who made the thing know it?
  bool of_making() const { return !parts.empty() || !ways.empty(); }

  /// Can it be seen on the mesh, whatever texts say?
  bool measured() const {
    return !colors.empty() || !outlines.empty() || !sizes.empty() || least_colors || most_colors || roughness ||
           !mounts.empty() || lightness;
  }
};

/// Has what was made the parts, or was it built in one of the ways?
bool is_made_so(const Making& making, const AttributeMeaning& meaning);

/// The words of attributes: one table for what is looked for and for the judgement of what was found.
class AttributeWords {
 public:
  static Result<AttributeWords> parse(std::string_view text, const std::string& source);
  static const AttributeWords& built_in();

  /// By a word or phrase in lower case, words separated by blanks: "stainless steel". Null if unknown.
  const AttributeMeaning* find(std::string_view phrase) const;
  /// Words that add nothing to the others of an attribute: "matte finish".
  bool says_nothing(std::string_view word) const;
  /// Is it about parts that a thing is used by, which must be there when they are said: drawers?
  bool is_demand(const AttributeMeaning& meaning) const;
  /// What things of a kind must have by what they are for: "two basins"; empty: nothing.
  std::string need_of(std::string_view kind) const;
  const std::map<std::string, std::string, std::less<>>& needs() const { return needs_; }
  /// The words in phrases that are known, the longest first; what is not known is a phrase of its own.
  std::vector<std::string> phrases(const std::vector<std::string>& words) const;
  const std::map<std::string, AttributeMeaning, std::less<>>& all() const { return meanings_; }

 private:
  std::map<std::string, AttributeMeaning, std::less<>> meanings_;
  std::map<std::string, bool, std::less<>> empty_words_;
  std::vector<std::string> demands_;  ///< labels of parts
  std::map<std::string, std::string, std::less<>> needs_;  ///< kind to phrase
};

/// What the words mean by which things are painted anew (data/finishes.json and the substances of
/// data/create/words.json): what can be painted can be judged. A tone is a colour near it; a substance a material
/// of that name in a colour near its own (what is dyed or painted: in any); a pattern a drawing of that name; gloss
/// a roughness; a shade ("weathered") a surface that was painted in it.
std::map<std::string, AttributeMeaning, std::less<>> finish_meanings();

}  // namespace roomgen
