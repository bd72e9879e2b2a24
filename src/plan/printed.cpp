#include "printed.h"

#include <algorithm>
#include <set>

#include "library/looks.h"
#include "shape/motifs.h"

namespace roomgen::plan {

namespace {

using language::Token;

constexpr std::uint32_t longest_print = 14;  // tokens

// Where something else begins: where the thing is, or the next thing.
bool ends_print(const Token& token) {
  static const std::set<std::string> words = {"above",  "over", "on", "next",    "beside",
                                              "near",   "in",   "at", "under",   "between",
                                              "behind", "and",  "by", "opposite"};
  return token.kind == Token::Kind::comma || token.kind == Token::Kind::stop ||
         words.count(token.text) > 0;
}

struct Shown {
  std::string text;     ///< "of a whale"
  std::string letters;  ///< what is in quotes, or said to be read there
};

// Of a sign what it says needs no quotes; who reads on a picture is in it.
Shown shown_behind(const std::vector<Token>& tokens, std::uint32_t from, bool is_sign) {
  Shown shown;
  bool is_quoted = false, is_said = false;
  const auto end = std::min<std::size_t>(tokens.size(), from + longest_print);
  for (std::size_t i = from; i < end; ++i) {
    const Token& token = tokens[i];
    if (token.kind == Token::Kind::quote) {
      if (is_quoted) break;
      is_quoted = true;
    } else if (is_quoted || (is_said && !ends_print(token))) {
      const bool is_joined = shown.letters.empty() || token.joint == Token::Joint::none;
      shown.letters += (is_joined ? "" : " ") + token.text + token.clitic;
    } else if (ends_print(token)) {
      break;
    } else {
      is_said = is_sign && shape::says_letters(token.text);
      shown.text += " " + token.text;
    }
  }
  return shown;
}

}  // namespace

std::string described_with_print(const brief::Brief& brief, const brief::Mention& mention,
                                 const KindTable& table) {
  const std::string& description = mention.description;
  const bool is_cloth = table.is_any_of(mention.category, printed_cloths);
  if (!is_cloth && !table.is_any_of(mention.category,
                                    {"picture", "map", "neon sign", "wall sign", "wall letters"}))
    return description;
  std::uint32_t from = 0;
  for (const auto index : mention.heard)
    if (const auto& heard = brief.heard[index]; heard.as == Heard::As::thing)
      from = std::max(from, heard.tokens.end);
  if (from == 0) return description;
  const bool is_sign = !is_cloth && !table.is_any_of(mention.category, {"picture", "map"});
  const Shown shown = shown_behind(brief.tokens, from, is_sign);
  if (!shown.letters.empty()) return "\"" + shown.letters + "\" " + description;
  const auto motifs = shape::motifs_in(shown.text);
  const bool is_told = motifs.empty() || !shape::motifs_in(description).empty();
  if (is_told) return description;
  return is_cloth ? description + " with " + motifs.front() + " pattern"
                  : motifs.front() + " " + description;
}

bool are_pictures_of_anything(const brief::Mention& mention, const KindTable& table) {
  return mention.quantity > 1 && table.is_any_of(mention.category, {"picture"}) &&
         shape::motifs_in(mention.description).empty();
}

}  // namespace roomgen::plan
