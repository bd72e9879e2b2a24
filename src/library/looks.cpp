#include "looks.h"

#include <algorithm>
#include <set>

#include "attribute_words.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

using Words = std::set<std::string, std::less<>>;

// Longer or shorter by this factor is another size than the one that was named.
constexpr double most_off = 1.3;
constexpr double least_said = 0.05;  // metres: thinner than this, thickness is nobody's wish

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

bool names_other_material(const AssetInfo& asset) {
  const auto told = words(asset.name + " " + join(asset.tags, " "));
  return std::any_of(told.begin(), told.end(), [&](const std::string& word) {
    const auto* meaning = AttributeWords::built_in().find(word);
    return meaning && !meaning->materials.empty();
  });
}

bool contradicts_outline(const AssetInfo& asset, WantedLooks::Outline outline,
                         const Vocabulary& vocabulary) {
  const bool told = vocabulary.is_a(asset.category, "table") || vocabulary.is_a(asset.category, "rug");
  if (outline == WantedLooks::Outline::any || !told) return false;
  return asset.round != (outline == WantedLooks::Outline::round);
}

// "6 drawers"
bool counts_parts(const std::vector<std::string>& told, const AttributeMeaning& meaning) {
  for (std::size_t i = 0; i + 1 < told.size(); ++i)
    for (const auto& counts : meaning.parts) {
      const auto wanted = counts.find(singular(told[i + 1]));
      const bool is_number = told[i].size() <= 3 && told[i].find_first_not_of("0123456789") == std::string::npos;
      if (is_number && wanted != counts.end() && wanted->second.contains(std::stoi(told[i]))) return true;
    }
  return false;
}

// Neither its kind nor its texts tell that it is made so.
bool contradicts_making(const AssetInfo& asset, const std::vector<std::string>& wanted, const Vocabulary& vocabulary,
                        const std::function<bool(const std::string&)>& says) {
  return std::any_of(wanted.begin(), wanted.end(), [&](const std::string& phrase) {
    const AttributeMeaning& meaning = *AttributeWords::built_in().find(phrase);
    const auto told = words(asset.name + " " + join(asset.tags, " "));
    const bool is_so = std::any_of(meaning.kinds.begin(), meaning.kinds.end(),
                                   [&](const std::string& kind) { return vocabulary.is_a(asset.category, kind); });
    const bool is_said = std::any_of(meaning.said.begin(), meaning.said.end(), [&](const std::string& word) {
      return std::find(told.begin(), told.end(), word) != told.end();
    });
    const auto pieces = words(phrase);
    return !is_so && !is_said && !counts_parts(told, meaning) && !std::all_of(pieces.begin(), pieces.end(), says);
  });
}

bool far_off(double have, double want) {
  return std::max(have, want) > least_said && std::max(have / want, want / have) > most_off;
}

bool any_far_off(const Vec3& have, const Vec3& want) {
  return far_off(have.x(), want.x()) || far_off(have.y(), want.y()) || far_off(have.z(), want.z());
}

}  // namespace

WantedLooks wanted_looks(const std::vector<std::string>& words) {
  const auto& table = AttributeWords::built_in();
  WantedLooks wanted;
  for (const auto& phrase : table.phrases(words)) {
    const AttributeMeaning* meaning = table.find(phrase);
    if (!meaning) continue;
    const auto has = [&](const char* outline) {
      return std::find(meaning->outlines.begin(), meaning->outlines.end(), outline) !=
             meaning->outlines.end();
    };
    if (!meaning->materials.empty()) wanted.materials.push_back(phrase);
    else if (!meaning->colors.empty()) wanted.colors.push_back(phrase);
    else if (meaning->of_making()) wanted.making.push_back(phrase);
    else if (has("round")) wanted.outline = WantedLooks::Outline::round;
    else if (has("square")) wanted.outline = WantedLooks::Outline::angular;
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
  if (contradicts_color(asset, wanted.colors)) return Contradiction::looks;
  if (wanted.materials.empty()) return Contradiction::none;
  // Painted wood is asked for by its colour.
  const bool unnatural = wanted.colors.empty() && contradicts_natural_color(asset, wanted.materials);
  return unnatural || (!said(wanted.materials) && names_other_material(asset)) ? Contradiction::looks
                                                                               : Contradiction::none;
}

bool contradicts_size(const AssetInfo& asset, const Vec3& wanted) {
  if (!any_far_off(asset.size, wanted)) return false;
  return asset.has_front || any_far_off({asset.size.y(), asset.size.x(), asset.size.z()}, wanted);
}

}  // namespace roomgen
