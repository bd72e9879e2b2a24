#include "looks.h"

#include <algorithm>

#include "library/attribute_words.h"
#include "library/looks.h"
#include "roomgen/base/text.h"

namespace roomgen::plan {

namespace {

// "school chair, sky blue shell": what is behind a comma says enough.
bool says_looks_of_parts(const std::string& description) {
  const auto comma = description.find(',');
  if (comma == std::string::npos) return false;
  const auto& table = AttributeWords::built_in();
  const auto phrases = table.phrases(words(description.substr(comma)));
  return std::any_of(phrases.begin(), phrases.end(), [&](const std::string& phrase) {
    const auto* meaning = table.find(phrase);
    return meaning && meaning->of_looks();
  });
}

// Without those that say an unwanted word: "deep pink" of "pink".
std::vector<std::string> without(std::vector<std::string> looks, const std::vector<std::string>& unwanted) {
  std::erase_if(looks, [&](const std::string& look) {
    const std::string spaced = " " + look + " ";
    return std::any_of(unwanted.begin(), unwanted.end(),
                       [&](const auto& word) { return spaced.find(" " + word + " ") != std::string::npos; });
  });
  return looks;
}

}  // namespace

const StyleMeaning* style_named(const brief::RoomKinds& kinds,
                                const std::vector<std::string>& styles) {
  for (const auto& word : styles) {
    if (const auto* meaning = StyleWords::built_in().find(word)) return meaning;
    const brief::Style* style = kinds.style(word);
    if (const auto* meaning = style ? StyleWords::built_in().find(style->adjective) : nullptr) return meaning;
  }
  return nullptr;
}

std::vector<std::string> unwanted_looks(const brief::Brief& brief) {
  std::vector<std::string> looks;
  for (const auto& [category, look] : brief.excluded_looks)
    if (category.empty()) looks.push_back(look);
  return looks;
}

Looks::Looks(const brief::RoomKinds& kinds, const KindTable& table,
             const std::vector<std::string>& styles, const StyleMeaning& palette,
             const std::vector<std::string>& unwanted, Random random)
    : table_(&table) {
  const auto add = [&](const std::vector<std::string>& of, const std::vector<std::string>& looks) {
    const auto allowed = without(looks, unwanted);
    if (!allowed.empty()) finishes_.emplace_back(of, random.pick(allowed));
  };
  for (const auto& look : palette.looks) add(look.kinds, look.words);
  for (const auto& word : styles)
    if (const brief::Style* style = kinds.style(word); style && adjective_.empty())
      adjective_ = style->adjective;
  if (const StyleMeaning* style = style_named(kinds, styles)) {
    adjective_ = style->name;
    for (const auto& look : style->looks) add(look.kinds, look.words);
  }
  of_style_ = finishes_.size();
  for (const auto& finish : kinds.finishes)
    add(finish.kinds, finish.words);
}

std::string Looks::describe(const std::string& category, const std::string& variant) const {
  std::vector<std::string> words;
  if (!adjective_.empty()) words.push_back(adjective_);
  if (const auto* finish = finish_of(category, finishes_.size())) words.push_back(*finish);
  if (!variant.empty()) words.push_back(variant);
  words.push_back(category);
  return join(words, " ");
}

std::string Looks::in_style(const std::string& category, const std::string& description) const {
  const WantedLooks said = wanted_looks(description);
  if (!said.colors.empty() || !said.materials.empty() || says_looks_of_parts(description)) return description;
  const auto* finish = finish_of(category, of_style_);
  if (!finish) return description;
  const std::string look = (adjective_.empty() ? "" : adjective_ + " ") + *finish + " ";
  return description.starts_with(look) ? description : look + description;
}

const std::string* Looks::finish_of(const std::string& category, std::size_t among) const {
  for (std::size_t i = 0; i < among; ++i)
    if (table_->is_any_of(category, finishes_[i].first)) return &finishes_[i].second;
  return nullptr;
}

}  // namespace roomgen::plan
