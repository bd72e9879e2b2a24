#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "finish_table.h"

namespace roomgen::create {

/// What words say of the looks of one part: "dark oak", "black and white striped", "glossy navy".
struct PartLook {
  const shape::Surface* substance = nullptr;
  std::string stuff;             ///< of the substance
  std::vector<Tone> tones;       ///< in the order of the words, shaded
  std::vector<Shade> shades;     ///< for the substance's own tone, where no other is named
  const PaintedPattern* pattern = nullptr;
  std::optional<double> gloss;   ///< roughness
  std::vector<std::string> said; ///< the phrases that were understood

  bool empty() const { return said.empty(); }
  /// The tone of most of it, where words tell.
  std::optional<Tone> tone() const;
};

Tone in_shades(Tone tone, const std::vector<Shade>& shades);

/// Words that nobody knows change nothing.
PartLook read_look(std::string_view text, const FinishTable& table = finish_table());

/// The looks that a description asks for by words of colour, substance, pattern and gloss: words by the
/// stuff of the parts that shall show them. "black metal and oak desk": metal: black metal, wood: oak.
/// What goes with no substance is said of what the kind is mostly made of.
std::map<std::string, std::string> wanted_finish(std::string_view description, std::string_view kind,
                                                 const FinishTable& table = finish_table());

}  // namespace roomgen::create
