#include "edit_text.h"

namespace roomgen {

bool EditText::ends(std::size_t at) const {
  if (at >= tokens.size()) return true;
  const auto kind = tokens[at].kind;
  return kind == Token::Kind::comma || kind == Token::Kind::stop || is_word(at, "and") || is_word(at, "then") ||
         is_word(at, "but");
}

std::string EditText::words_from(std::size_t begin, std::size_t end) const {
  std::string text;
  for (std::size_t i = begin; i < std::min(end, tokens.size()); ++i) {
    const bool joined = raw[i].joint == language::Token::Joint::hyphen && i > begin;
    text += (text.empty() ? "" : joined ? "-" : " ") + tokens[i].text;
  }
  return text;
}

const Object* EditText::object(std::string_view id) const {
  if (const Object* there = find_object(scene, id)) return there;
  return find_object(coming, id);
}

Error not_understood(const std::string& what) { return {Error::Kind::not_understood, what}; }

}  // namespace roomgen
