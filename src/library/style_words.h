#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"

namespace roomgen {

/// What a word of style means (data/styles.json, docs/finishes.md).
struct StyleMeaning {
  /// How kinds of things look in it: one of the words, which data/finishes.json and data/materials.json know.
  struct Look {
    std::vector<std::string> kinds, words;
  };

  std::string name;
  std::vector<std::string> walls, floors, accents;  ///< of which one is chosen; none: whatever there is
  std::vector<Look> looks;                          ///< the first whose kinds fit counts
  std::vector<std::string> more, fewer;             ///< kinds that go with it, and that do not
  std::string sheen;  ///< a word of gloss, which its things have where nothing else was said
  std::vector<std::string> colors, materials;       ///< by which a thing is judged to be of it
};

class StyleWords {
 public:
  static Result<StyleWords> parse(std::string_view text, const std::string& source);
  static const StyleWords& built_in();

  /// By its name or another name of it, in lower case; null if there is none.
  const StyleMeaning* find(std::string_view word) const;
  /// The first style that a text names; null if none.
  const StyleMeaning* named_in(std::string_view text) const;
  const std::map<std::string, StyleMeaning, std::less<>>& all() const { return styles_; }
  /// Groups of kinds that go together and wear the colours, the woods, or another stuff of a room.
  using Groups = std::vector<std::vector<std::string>>;
  const Groups& worn_by_colors() const { return worn_by_colors_; }
  /// "pale green walls", which go with green; empty: whatever walls there are.
  std::string walls_with(const std::string& color) const;
  const Groups& worn_by_woods() const { return worn_by_woods_; }
  /// Null for what is no stuff that things wear so.
  const Groups* worn_by_stuff(std::string_view word) const;

 private:
  std::map<std::string, StyleMeaning, std::less<>> styles_;
  Groups worn_by_colors_, worn_by_woods_;
  std::map<std::string, Groups, std::less<>> worn_by_stuffs_;
  std::map<std::string, std::string, std::less<>> walls_by_color_;
  std::map<std::string, std::string, std::less<>> names_;  ///< words parted by blanks, to the style's name
};

}  // namespace roomgen
