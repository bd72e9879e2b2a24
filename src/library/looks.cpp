#include "looks.h"

#include <algorithm>
#include <set>

#include "attribute_words.h"
#include "qualifiers.h"
#include "seen_assets.h"
#include "roomgen/base/text.h"
#include "shape/motifs.h"

namespace roomgen {

namespace {

using Words = std::set<std::string, std::less<>>;

constexpr std::size_t most_colors = 7;  // a word that leaves more open tells nothing of colour

bool tells_color(const AttributeMeaning& meaning) {
  return !meaning.colors.empty() && meaning.colors.size() <= most_colors;
}

Words colors_of(const std::vector<std::string>& phrases) {
  Words colors;
  for (const auto& phrase : phrases) {
    const auto* meaning = AttributeWords::built_in().find(phrase);
    if (meaning && tells_color(*meaning)) colors.insert(meaning->colors.begin(), meaning->colors.end());
  }
  return colors;
}

// What is seen first has another colour.
bool contradicts_color(const AssetInfo& asset, const std::vector<std::string>& wanted) {
  const Words accepted = colors_of(wanted);
  return !accepted.empty() && !asset.colors.empty() && !accepted.count(asset.colors.front());
}

// No main colour is one that the material has: legs of oak may carry a white top.
bool contradicts_natural_color(const AssetInfo& asset, const std::vector<std::string>& materials) {
  const Words accepted = colors_of(materials);
  return !accepted.empty() && !asset.colors.empty() &&
         std::none_of(asset.colors.begin(), asset.colors.end(),
                      [&](const std::string& color) { return accepted.count(color) > 0; });
}

// "Black leather" is a part of it, for who saw it, whatever else there is.
bool has_part_of(const AssetInfo& asset, const WantedLooks& wanted, const Vocabulary& vocabulary) {
  const SeenAsset* seen = seen_asset(asset.ref);
  if (!seen || wanted.colors.empty()) return false;
  const Words colors = colors_of(wanted.colors);
  for (const auto& part : seen->parts)
    for (const auto& material : wanted.materials) {
      const auto family = vocabulary.family(material);
      const bool is_of_it = std::find(family.begin(), family.end(), part.material) != family.end();
      if (is_of_it && colors.count(part.color)) return true;
    }
  return false;
}

bool names_other_material(const AssetInfo& asset) {
  const auto told = words(asset.name + " " + join(asset.tags, " "));
  return std::any_of(told.begin(), told.end(), [&](const std::string& word) {
    const auto* meaning = AttributeWords::built_in().find(word);
    return meaning && !meaning->materials.empty();
  });
}

bool is_kind_of(const AssetInfo& asset, const std::vector<std::string>& kinds,
                const Vocabulary& vocabulary) {
  return std::any_of(kinds.begin(), kinds.end(),
                     [&](const auto& kind) { return vocabulary.is_a(asset.category, kind); });
}

// An oval one is neither round nor square.
bool contradicts_outline(const AssetInfo& asset, const std::string& outline,
                         const Vocabulary& vocabulary) {
  static const std::vector<std::string> told = {"table", "rug", "stool", "ottoman", "tray"};
  if (outline.empty() || !is_kind_of(asset, told, vocabulary)) return false;
  const SeenAsset* seen = seen_asset(asset.ref);
  if (outline == "round" && seen) return seen->shape != "round";
  return asset.round != (outline == "round" || outline == "oval");
}

// Neither its kind nor who saw it, nor its texts, tell that it is made so. Of parts who saw it is
// believed alone.
bool contradicts_making(const AssetInfo& asset, const std::vector<std::string>& wanted,
                        const Vocabulary& vocabulary,
                        const std::function<bool(const std::string&)>& says) {
  const SeenAsset* seen = seen_asset(asset.ref);
  const auto told = words(asset.name + " " + join(asset.tags, " "));
  return std::any_of(wanted.begin(), wanted.end(), [&](const std::string& phrase) {
    const AttributeMeaning& meaning = *AttributeWords::built_in().find(phrase);
    const auto& said = meaning.said;
    if (is_kind_of(asset, meaning.kinds, vocabulary)) return false;
    if (seen && is_made_so(seen->has, meaning)) return false;
    if (std::find_first_of(told.begin(), told.end(), said.begin(), said.end()) != told.end()) return false;
    const auto pieces = words(phrase);
    return (seen && !meaning.parts.empty()) || !std::all_of(pieces.begin(), pieces.end(), says);
  });
}

// A picture whose own texts tell of no whale shows something else, and so does a rug.
bool shows_other(const AssetInfo& asset, const WantedLooks& wanted, const Vocabulary& vocabulary) {
  const bool is_cloth = is_kind_of(asset, printed_cloths, vocabulary);
  const auto& motifs = is_cloth ? wanted.prints : wanted.motifs;
  if (motifs.empty() || (!is_cloth && !is_kind_of(asset, {"picture"}, vocabulary))) return false;
  const auto shown = shape::motifs_in(asset.name + " " + join(asset.tags, " "));
  return std::find_first_of(shown.begin(), shown.end(), motifs.begin(), motifs.end()) == shown.end();
}

}  // namespace

WantedLooks wanted_looks(std::string_view description) {
  const auto& table = AttributeWords::built_in();
  const Qualifiers said = qualify(description);
  WantedLooks wanted;
  wanted.motifs = shape::motifs_in(description);
  wanted.prints = shape::motifs_on_cloth(description);
  for (const auto& phrase : table.phrases(said.own)) {
    const AttributeMeaning* meaning = table.find(phrase);
    if (!meaning) continue;
    if (!meaning->materials.empty()) wanted.materials.push_back(phrase);
    else if (!meaning->colors.empty()) wanted.colors.push_back(phrase);
    else if (meaning->of_making()) wanted.making.push_back(phrase);
    else if (!meaning->outlines.empty()) wanted.outline = meaning->outlines.front();
  }
  for (const auto& phrase : table.phrases(said.parts))
    for (const auto& word : {phrase, words(phrase).back()}) {  // "sliding doors" are doors
      const AttributeMeaning* meaning = table.find(word);
      if (!meaning || (meaning->ways.empty() && !table.is_demand(*meaning))) continue;
      wanted.making.push_back(word);
      if (table.is_demand(*meaning)) break;
    }
  return wanted;
}

bool is_made_as_wanted(const Making& making, const WantedLooks& wanted) {
  return std::all_of(wanted.making.begin(), wanted.making.end(), [&](const std::string& phrase) {
    return is_made_so(making, *AttributeWords::built_in().find(phrase));
  });
}

Contradiction contradiction(const AssetInfo& asset, const WantedLooks& wanted, const Vocabulary& vocabulary,
                            const std::function<bool(const std::string&)>& says) {
  const auto said = [&](const std::vector<std::string>& phrases) {
    return std::any_of(phrases.begin(), phrases.end(), [&](const std::string& phrase) {
      const auto pieces = words(phrase);
      return std::all_of(pieces.begin(), pieces.end(), says);
    });
  };
  if (contradicts_outline(asset, wanted.outline, vocabulary)) return Contradiction::form;
  if (contradicts_making(asset, wanted.making, vocabulary, says)) return Contradiction::form;
  if (shows_other(asset, wanted, vocabulary)) return Contradiction::looks;
  if (has_part_of(asset, wanted, vocabulary)) return Contradiction::none;
  if (contradicts_color(asset, wanted.colors)) return Contradiction::looks;
  if (wanted.materials.empty()) return Contradiction::none;
  // Painted wood is asked for by its colour.
  const bool unnatural = wanted.colors.empty() && contradicts_natural_color(asset, wanted.materials);
  return unnatural || (!said(wanted.materials) && names_other_material(asset)) ? Contradiction::looks
                                                                               : Contradiction::none;
}

}  // namespace roomgen
