#include "asset_looks.h"

#include <algorithm>

#include "roomgen/base/text.h"

namespace roomgen {

namespace {

bool says(const std::string& text, const std::string& word) {
  const auto pieces = words(text);
  return std::any_of(pieces.begin(), pieces.end(), [&](const std::string& piece) {
    return piece == word || singular(piece) == singular(word);
  });
}

}  // namespace

bool looks_like(const AssetInfo& asset, const std::string& word) {
  const auto has = [&](const std::string& text) { return says(text, word); };
  if (word == "round" && asset.round) return true;
  if (has(asset.name) || std::any_of(asset.tags.begin(), asset.tags.end(), has)) return true;
  if (std::any_of(asset.colors.begin(), asset.colors.end(), has)) return true;
  if (!asset.ref.procedural) return false;
  const auto description = asset.ref.procedural->params.find("description");
  return description != asset.ref.procedural->params.end() && description->is_string() &&
         says(description->get<std::string>(), word);
}

}  // namespace roomgen
