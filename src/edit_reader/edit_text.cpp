#include "edit_text.h"

namespace roomgen {

// "it is so dark here": no new clause begins.
bool EditText::says_how_much(std::size_t at) const {
  if (at == 0) return false;
  for (const char* be : {"is", "are", "was", "were", "looks", "look", "feels", "seems", "not", "its"})
    if (is_word(at - 1, be)) return true;
  return false;
}

bool EditText::ends(std::size_t at) const {
  return is_mark(at) || is_word(at, "and") || is_word(at, "then") ||
         is_word(at, "but") || (is_word(at, "so") && !says_how_much(at));
}

std::size_t EditText::end_of_most(std::size_t at) const {
  const std::size_t begin = behind_comma(at);
  const auto length = longest_in(edits.possible, tokens, begin);
  return length > 0 ? begin + length : at;
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

EditText in_scene(const EditText& text, const Scene& scene) {
  EditText other{scene,       text.kinds,  text.edits,  text.words, text.raw,    text.tokens,
                 text.mentioned, text.latest, text.coming, text.gone,  text.recall, text.depth};
  for (auto* ids : {&other.mentioned, &other.latest, &other.gone, &other.recall.touched, &other.recall.added})
    std::erase_if(*ids, [&](const std::string& id) { return !other.object(id); });
  return other;
}

Error not_understood(const std::string& what) { return {Error::Kind::not_understood, what}; }

}  // namespace roomgen
