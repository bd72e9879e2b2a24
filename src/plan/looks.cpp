#include "looks.h"

#include "roomgen/base/text.h"

namespace roomgen::design {

Looks::Looks(const RoomKinds& kinds, const KindTable& table,
             const std::vector<std::string>& styles, Random random)
    : table_(&table) {
  for (const auto& word : styles)
    if (const Style* style = kinds.style(word); style && adjective_.empty())
      adjective_ = style->adjective;
  for (const auto& finish : kinds.finishes)
    if (!finish.words.empty()) finishes_.emplace_back(finish.kinds, random.pick(finish.words));
}

std::string Looks::describe(const std::string& category, const std::string& variant) const {
  std::vector<std::string> words;
  if (!adjective_.empty()) words.push_back(adjective_);
  for (const auto& [kinds, word] : finishes_)
    if (table_->is_any_of(category, kinds)) {
      words.push_back(word);
      break;
    }
  if (!variant.empty()) words.push_back(variant);
  words.push_back(category);
  return join(words, " ");
}

}  // namespace roomgen::design
