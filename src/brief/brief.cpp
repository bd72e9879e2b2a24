#include "brief.h"

#include <utility>

namespace roomgen::brief {

std::string words_of(const Brief& brief) {
  std::string words;
  for (const auto& token : brief.tokens) words += token.text + " ";
  return words;
}

std::size_t hear(Brief& brief, const language::Run& tokens, Heard::As as, std::string word) {
  brief.heard.push_back({tokens, as, std::move(word)});
  return brief.heard.size() - 1;
}

}  // namespace roomgen::brief
