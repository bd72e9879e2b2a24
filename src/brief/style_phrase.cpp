#include "style_phrase.h"

#include <algorithm>

#include "library/style_words.h"

namespace roomgen::brief {

namespace {

constexpr std::size_t longest_style = 3;  ///< words

}  // namespace

std::optional<StylePhrase> style_at(std::span<const Token> tokens, std::size_t at, const RoomKinds& kinds) {
  std::optional<StylePhrase> best;
  std::string name;
  for (std::size_t n = 0; n < longest_style && at + n < tokens.size(); ++n) {
    if (tokens[at + n].kind != Token::Kind::word) break;
    name += (n ? " " : "") + tokens[at + n].text;
    const Style* style = kinds.style(name);
    const bool is_named = StyleWords::built_in().find(name) != nullptr;
    if (style || is_named)
      best = StylePhrase{name, n + 1, is_named || !style->adjective.empty() || !style->more.empty()};
  }
  return best;
}

void hear_style(Brief& brief, const StylePhrase& style, const language::Run& tokens) {
  hear(brief, tokens, Heard::As::style, style.name);
  if (std::find(brief.styles.begin(), brief.styles.end(), style.name) == brief.styles.end())
    brief.styles.push_back(style.name);
}

}  // namespace roomgen::brief
