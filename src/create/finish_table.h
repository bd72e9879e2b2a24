#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/finish_words.h"
#include "words.h"

namespace roomgen::create {

/// How a pattern is painted: by a pattern of shape/pattern.h or geometry/texture.h.
struct PaintedPattern {
  std::string paint;          ///< its name there
  std::optional<Tone> first;  ///< unless words or the thing itself give another
  Tone second = Tone::Constant(235);
  double scale = 1.0;
};

/// The words for the looks of a thing's parts (data/finishes.json; docs/finishes.md). A stuff is what
/// parts are made of, roughly: wood, upholstery, metal.
struct FinishTable {
  WordMap<Tone> tones;
  WordMap<Shade> shades;
  WordMap<double> gloss;  ///< roughness
  WordMap<PaintedPattern> patterns;
  WordMap<shape::Surface> substances;  ///< those of data/create/words.json too
  WordMap<std::string> stuffs;         ///< of a substance
  WordMap<std::string> surfaces;       ///< what surfaces of a mesh are called, to their stuff
  WordSet untouched;                   ///< stuffs that are painted only when they are named
  WordMap<std::string> parts;          ///< "cushion", to its stuff
  std::vector<std::pair<std::vector<std::string>, std::string>> made_of;  ///< kinds, the first that fits

  /// What a kind of thing is made of for the most part; empty for what is not painted.
  const std::string& main_stuff(std::string_view kind) const;
};

Result<FinishTable> parse_finish_table(std::string_view text, const std::string& source);
/// The table compiled into the library.
const FinishTable& finish_table();

}  // namespace roomgen::create
