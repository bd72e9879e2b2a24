#include "bound_mentions.h"

#include <algorithm>

namespace roomgen::brief {

namespace {

constexpr int most_of_a_line = 200;
constexpr std::size_t most_name_bytes = 150;  // bytes
constexpr std::size_t most_description_bytes = 1000;

// The last words: the noun is among them.
void bound(std::string& text, std::size_t longest) {
  if (text.size() <= longest) return;
  std::size_t begin = text.find(' ', text.size() - longest);
  begin = begin == std::string::npos ? text.size() - longest : begin + 1;
  while (begin < text.size() && (static_cast<unsigned char>(text[begin]) & 0xC0u) == 0x80u) ++begin;
  text.erase(0, begin);
}

// Those that fit together; the others stay in the description.
void bound(std::vector<std::string>& texts) {
  std::size_t size = 0, count = 0;
  for (; count < texts.size(); ++count) {
    bound(texts[count], most_name_bytes);
    size += texts[count].size() + 1;
    if (size > most_name_bytes) break;
  }
  texts.resize(std::max<std::size_t>(count, texts.empty() ? 0 : 1));
}

}  // namespace

std::string bounded_name(std::string text) {
  bound(text, most_name_bytes);
  return text;
}

void bound_mentions(Brief& brief) {
  for (auto& mention : brief.mentions) {
    if (mention.quantity > most_of_a_line)
      brief.notes.push_back(std::to_string(mention.quantity) + " of \"" + mention.description.substr(0, most_name_bytes) +
                            "\" are more than the limit of " + std::to_string(most_of_a_line));
    mention.quantity = std::min(mention.quantity, most_of_a_line);
    mention.least = std::min(mention.least, most_of_a_line);
    mention.most = std::min(mention.most, most_of_a_line);
    bound(mention.category, most_name_bytes);
    bound(mention.noun, most_name_bytes);
    bound(mention.description, most_description_bytes);
    bound(mention.naming);
    for (auto& look : mention.looks) bound(look, most_name_bytes);
    for (auto& part : mention.parts) bound(part, most_name_bytes);
  }
  for (auto& category : brief.excluded) bound(category, most_name_bytes);
  for (auto& [category, look] : brief.excluded_looks) bound(category, most_name_bytes), bound(look, most_name_bytes);
}

}  // namespace roomgen::brief
