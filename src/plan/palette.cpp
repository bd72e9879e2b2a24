#include <map>

#include "looks.h"
#include "roomgen/base/text.h"
#include "scene/finish_words.h"

namespace roomgen::plan {

namespace {

using Groups = StyleWords::Groups;

// By the last word that tells: "salt-bleached wood" is worn by furniture, "black leather" by seats, colours by what is
// soft or small; null: by a wall.
const Groups* worn_by(const std::string& said) {
  const FinishWords& finishes = finish_words();
  const StyleWords& styles = StyleWords::built_in();
  const auto of_surface = [&](const std::string& surface) {
    return surface == "boards" ? &styles.worn_by_woods() : nullptr;
  };
  const auto all = words(said);
  for (auto word = all.rbegin(); word != all.rend(); ++word) {
    if (const Groups* groups = styles.worn_by_stuff(*word)) return groups;
    if (const auto named = finishes.substances.find(*word); named != finishes.substances.end())
      return of_surface(named->second.surface);
    if (const auto named = finishes.surface_names.find(*word); named != finishes.surface_names.end())
      return of_surface(named->second);
  }
  return &styles.worn_by_colors();
}

}  // namespace

StyleMeaning style_of_palette(const std::vector<std::string>& palette) {
  StyleMeaning style;
  std::map<const Groups*, std::vector<std::string>> words;
  for (const auto& said : palette) {
    if (const Groups* groups = worn_by(said))
      words[groups].push_back(said);
    else
      style.accents.push_back(said + " wall");
  }
  // Those of a stuff come before the colours: leather sofas, green rugs.
  const Groups* colors = &StyleWords::built_in().worn_by_colors();
  const auto wear = [&](const Groups& groups, const std::vector<std::string>& said) {
    for (const auto& kinds : groups) style.looks.push_back({kinds, said});
  };
  for (const auto& said : palette)
    if (const Groups* groups = worn_by(said); groups && groups != colors) wear(*groups, words[groups]);
  if (words.count(colors)) wear(*colors, words[colors]);
  // The first colour that walls have.
  for (const auto& said : words[colors]) {
    const std::string walls = StyleWords::built_in().walls_with(said.substr(said.rfind(' ') + 1));
    if (!walls.empty() && style.walls.empty()) style.walls.push_back(walls);
  }
  return style;
}

}  // namespace roomgen::plan
