#pragma once

#include <string>
#include <vector>

#include "base/random.h"
#include "brief/brief.h"
#include "brief/room_kinds.h"
#include "library/style_words.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::plan {

/// The style that a prompt names first, if it is one of data/styles.json; else null.
const StyleMeaning* style_named(const brief::RoomKinds& kinds,
                                const std::vector<std::string>& styles);

/// The looks that a prompt wants nothing to have, whatever it is.
std::vector<std::string> unwanted_looks(const brief::Brief& brief);

/// How the things of one room look: one adjective of style, one finish for each group of kinds, those of
/// the palette before those of the style before those of everybody, so that what stands together goes together. None
/// has an unwanted word.
class Looks {
 public:
  Looks(const brief::RoomKinds& kinds, const KindTable& table,
        const std::vector<std::string>& styles, const StyleMeaning& palette,
        const std::vector<std::string>& unwanted, Random random);

  /// "modern wooden double bed"
  std::string describe(const std::string& category, const std::string& variant) const;

  /// What the style gives a thing of which somebody said neither colour nor material, before the words
  /// that were said: "gothic ebony wardrobe".
  std::string in_style(const std::string& category, const std::string& description) const;

 private:
  const std::string* finish_of(const std::string& category, std::size_t among) const;

  const KindTable* table_;
  std::string adjective_;
  std::size_t of_style_ = 0;  ///< so many of the finishes are the style's
  std::vector<std::pair<std::vector<std::string>, std::string>> finishes_;  ///< kinds and the word
};

/// What the words of a prompt say of the light: "a candlelit evening" (the moods of data/materials.json). Words
/// that describe a thing or are denied say nothing. The brief hears them.
Lighting light_of(brief::Brief& brief);

/// Says what is still open.
void fill(Lighting& light, const Lighting& more);

/// The look of a room whose prompt names colours and stuffs without the things that have them: colours are worn by what
/// is soft or small, woods by furniture, metals by lamps (data/styles.json says by which kinds), brick, plaster and
/// stone by a wall.
StyleMeaning style_of_palette(const std::vector<std::string>& palette);

}  // namespace roomgen::plan
