#include "palette.h"

#include <algorithm>

#include "roomgen/base/text.h"
#include "scene/finish_words.h"

namespace roomgen::design {

namespace {

enum class Stuff { color, wood, wall };

// By the last word that tells: "salt-bleached wood" is wood, "raw brick" a wall.
Stuff stuff_of(const std::string& said) {
  const FinishWords& finishes = finish_words();
  const auto all = words(said);
  for (auto word = all.rbegin(); word != all.rend(); ++word) {
    if (const auto named = finishes.substances.find(*word); named != finishes.substances.end())
      return named->second.surface == "boards" ? Stuff::wood : Stuff::wall;
    if (const auto named = finishes.surface_names.find(*word); named != finishes.surface_names.end())
      return named->second == "boards" ? Stuff::wood : Stuff::wall;
  }
  return Stuff::color;
}

}  // namespace

StyleMeaning style_of_palette(const std::vector<std::string>& palette) {
  const StyleWords& styles = StyleWords::built_in();
  StyleMeaning style;
  std::vector<std::string> colors, woods;
  for (const auto& said : palette) switch (stuff_of(said)) {
      case Stuff::color:
        colors.push_back(said);
        break;
      case Stuff::wood:
        woods.push_back(said);
        break;
      case Stuff::wall:
        style.accents.push_back(said + " wall");
    }
  if (!colors.empty())
    for (const auto& kinds : styles.worn_by_colors()) style.looks.push_back({kinds, colors});
  if (!woods.empty())
    for (const auto& kinds : styles.worn_by_woods()) style.looks.push_back({kinds, woods});
  return style;
}

}  // namespace roomgen::design
