#include "brief.h"

#include <utility>

namespace roomgen::brief {

std::size_t hear(Brief& brief, const language::Run& tokens, Heard::As as, std::string word) {
  brief.heard.push_back({tokens, as, std::move(word)});
  return brief.heard.size() - 1;
}

}  // namespace roomgen::brief
