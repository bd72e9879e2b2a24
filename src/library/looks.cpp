#include "roomgen/library/looks.h"

#include <algorithm>
#include <map>
#include <set>

#include "roomgen/base/text.h"

namespace roomgen {

namespace {

using Words = std::set<std::string, std::less<>>;

// Longer or shorter by this factor is another size than the one that was named.
constexpr double most_off = 1.3;
constexpr double least_said = 0.05;  // metres: thinner than this, thickness is nobody's wish

// The names that catalogues give to colours, by the family of the word that asks for one.
const std::map<std::string, Words, std::less<>>& colors_by_family() {
  static const std::map<std::string, Words, std::less<>> colors = {
      {"white", {"white", "beige"}}, {"grey", {"grey"}},     {"black", {"black"}},
      {"brown", {"brown", "orange"}}, {"beige", {"beige"}},  {"red", {"red"}},
      {"orange", {"orange", "brown"}}, {"yellow", {"yellow"}}, {"green", {"green"}},
      {"blue", {"blue"}},             {"purple", {"purple"}}, {"pink", {"pink"}},
      // Materials that are seldom painted show their own.
      {"wood", {"brown", "beige", "orange", "yellow"}},
      {"bamboo", {"brown", "beige", "orange", "yellow"}},
      {"rattan", {"brown", "beige", "orange", "yellow"}},
      {"brass", {"yellow", "brown", "orange", "beige"}},
      {"chrome", {"grey", "white", "black"}},
      {"leather", {"brown", "black", "beige", "white", "grey", "red", "orange"}}};
  return colors;
}

const Words material_families = {"wood", "metal", "chrome",  "brass",   "glass", "leather", "fabric",
                                 "plastic", "stone", "rattan", "ceramic", "bamboo"};

// Gold and mustard are brownish in a picture.
Words colors_of(const std::string& word, const Vocabulary& vocabulary) {
  static const Words golden = {"gold", "golden", "mustard", "copper", "terracotta", "brass", "bronze"};
  if (golden.count(word)) return {"yellow", "brown", "orange", "beige"};
  if (word == "silver") return {"grey", "white"};
  const auto found = colors_by_family().find(vocabulary.family_name(word));
  return found == colors_by_family().end() ? Words{} : found->second;
}

bool has_any(const std::vector<std::string>& colors, const Words& accepted) {
  return std::any_of(colors.begin(), colors.end(),
                     [&](const std::string& color) { return accepted.count(color) > 0; });
}

bool contradicts_color(const AssetInfo& asset, const std::vector<std::string>& wanted,
                       const Vocabulary& vocabulary) {
  Words accepted;
  for (const auto& word : wanted) accepted.merge(colors_of(word, vocabulary));
  return !accepted.empty() && !asset.colors.empty() && !has_any(asset.colors, accepted);
}

bool names_other_material(const AssetInfo& asset, const Vocabulary& vocabulary) {
  const auto told = words(asset.name + " " + join(asset.tags, " "));
  return std::any_of(told.begin(), told.end(), [&](const std::string& word) {
    return material_families.count(vocabulary.family_name(word)) > 0;
  });
}

bool contradicts_outline(const AssetInfo& asset, WantedLooks::Outline outline,
                         const Vocabulary& vocabulary) {
  const bool told = vocabulary.is_a(asset.category, "table") || vocabulary.is_a(asset.category, "rug");
  if (outline == WantedLooks::Outline::any || !told) return false;
  return asset.round != (outline == WantedLooks::Outline::round);
}

bool far_off(double have, double want) {
  return std::max(have, want) > least_said && std::max(have / want, want / have) > most_off;
}

bool any_far_off(const Vec3& have, const Vec3& want) {
  return far_off(have.x(), want.x()) || far_off(have.y(), want.y()) || far_off(have.z(), want.z());
}

}  // namespace

WantedLooks wanted_looks(const std::vector<std::string>& words, const Vocabulary& vocabulary) {
  WantedLooks wanted;
  for (const auto& word : words) {
    const std::string family = vocabulary.family_name(word);
    if (material_families.count(family)) wanted.materials.push_back(word);
    else if (colors_by_family().count(family)) wanted.colors.push_back(word);
    else if (word == "round" || word == "circular" || word == "oval")
      wanted.outline = WantedLooks::Outline::round;
    else if (word == "square" || word == "rectangular")
      wanted.outline = WantedLooks::Outline::angular;
  }
  return wanted;
}

bool contradicts(const AssetInfo& asset, const WantedLooks& wanted, const Vocabulary& vocabulary,
                 const std::function<bool(const std::string&)>& says) {
  const auto said = [&](const std::vector<std::string>& words) {
    return std::any_of(words.begin(), words.end(), says);
  };
  if (contradicts_outline(asset, wanted.outline, vocabulary)) return true;
  if (!said(wanted.colors) && contradicts_color(asset, wanted.colors, vocabulary)) return true;
  if (wanted.materials.empty() || said(wanted.materials)) return false;
  if (names_other_material(asset, vocabulary)) return true;
  // Painted wood is asked for by its colour.
  return wanted.colors.empty() && contradicts_color(asset, wanted.materials, vocabulary);
}

bool contradicts_size(const AssetInfo& asset, const Vec3& wanted) {
  if (!any_far_off(asset.size, wanted)) return false;
  return asset.has_front || any_far_off({asset.size.y(), asset.size.x(), asset.size.z()}, wanted);
}

}  // namespace roomgen
