#include "wording.h"

namespace roomgen {

namespace {

using Token = brief::Token;

// "sorry, no,": words that correct, with marks between them.
std::size_t end_of_words(const EditText& text, std::size_t at) {
  std::size_t end = at;
  for (std::size_t i = at; i < text.tokens.size();) {
    const auto length = longest_in(text.edits.corrections, text.tokens, i);
    if (length > 0) end = i += length;
    else if (text.is_comma(i)) ++i;
    else break;
  }
  return end;
}

// "no rug" is an order; "no, the rug" takes something back.
bool takes_back(const EditText& text, std::size_t begin, std::size_t end) {
  if (end == begin) return false;
  const bool is_no = text.is_word(begin, "no") && end == begin + 1;
  const bool is_weak =
      text.is_word(begin, "actually") || text.is_word(begin, "better") || text.is_word(begin, "rather");
  if (is_weak && end == begin + 1) return false;
  return !is_no || text.is_comma(end) ||
         (end < text.tokens.size() && text.words.definite.count(text.tokens[end].text) > 0);
}

}  // namespace

std::optional<Correction> correction_in(const EditText& text) {
  for (std::size_t i = 1; i + 1 < text.tokens.size(); ++i) {
    if (!text.is_comma(i)) continue;
    std::size_t end = end_of_words(text, i + 1);
    if (!takes_back(text, i + 1, end)) continue;
    end = text.behind_comma(end);
    if (end < text.tokens.size() && !text.ends(end)) return Correction{i, end};
  }
  return std::nullopt;
}

std::vector<EditText> corrected(const EditText& text, const Correction& correction) {
  std::vector<EditText> all;
  const auto offset = [](std::size_t at) { return static_cast<std::ptrdiff_t>(at); };
  for (std::size_t keep = correction.begin; keep-- > 0 && text.tokens[keep].kind != Token::Kind::stop;) {
    EditText shorter = text;
    shorter.raw.erase(shorter.raw.begin() + offset(keep), shorter.raw.begin() + offset(correction.end));
    shorter.tokens.erase(shorter.tokens.begin() + offset(keep), shorter.tokens.begin() + offset(correction.end));
    all.push_back(std::move(shorter));
  }
  return all;
}

}  // namespace roomgen
