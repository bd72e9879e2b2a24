#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/json.h"

namespace roomgen::shape {

/// A drawing with a name (data/motifs.json): what posters, paintings and the like show.
struct Motif {
  std::string name;
  bool turned = true;  ///< may stand the other way round
  const Json* drawing = nullptr;
};

/// Its shapes without skies, seas and floors, which reach beyond the square; all of a mere scene.
Json figure_of(const Motif& motif);

/// Null if there is none. They live as long as the program.
const Motif* find_motif(std::string_view name);

/// The motifs that words name, in their order, each once: "a poster with two cranes" names crane.
std::vector<std::string> motifs_in(std::string_view words);
/// Those that cloth would show: of "lemon cushion" only if it says so, "with lemons".
std::vector<std::string> motifs_on_cloth(std::string_view words);
/// Does the word say that letters stand behind it: "reads", "saying"?
bool says_letters(std::string_view word);
/// The palette that words of style ask for: "Japanese" for ink; empty if they ask for none.
std::string palette_in(std::string_view words);

/// What a sign or a board says where words call it a menu board or an open sign; empty where they
/// do not.
std::string text_in(std::string_view words);

/// The colours of a palette ("ink"), dark to light; null if there is none.
const std::vector<std::string>* find_palette(std::string_view name);

}  // namespace roomgen::shape
