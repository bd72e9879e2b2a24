#include "prints.h"

#include <algorithm>
#include <array>
#include <vector>

#include "roomgen/base/text.h"
#include "shape/motifs.h"

namespace roomgen::create {

namespace {

constexpr std::size_t longest_print = 120;  // bytes

// An apostrophe within a word opens no quote.
bool opens(std::string_view text, std::size_t at, std::string_view mark) {
  if (text.substr(at, mark.size()) != mark) return false;
  return mark != "'" || at == 0 || text[at - 1] == ' ';
}

// The words between marks of a kind, with where they begin and end.
std::string quoted(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> marks = {
      {{"\"", "\""}, {"“", "”"}, {"‘", "’"}, {"'", "'"}}};
  for (std::size_t at = 0; at < text.size(); ++at)
    for (const auto& [open, close] : marks) {
      if (!opens(text, at, open)) continue;
      const std::size_t first = at + open.size(), last = text.find(close, first);
      if (last == std::string_view::npos || last == first) continue;
      return std::string(trim(text.substr(first, std::min(last - first, longest_print))));
    }
  return "";
}

// "a neon sign saying OPEN LATE": what is written in capitals behind the verb.
std::string spelt(std::string_view text) {
  std::vector<std::string> result;
  bool is_said = false;
  for (const auto& piece : split(text, ' ')) {
    const bool is_capital = !piece.empty() && piece == [&] {
      std::string upper = piece;
      for (char& c : upper)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
      return upper;
    }();
    if (is_said && is_capital)
      result.push_back(piece);
    else if (is_said)
      break;
    if (shape::says_letters(lower(piece))) is_said = true;
  }
  return join(result, " ");
}

}  // namespace

std::string in_lines(std::string_view words) {
  constexpr std::size_t longest_line = 10;  // letters
  if (words.find('\n') != std::string_view::npos) return std::string(words);
  std::string result;
  std::size_t line = 0;
  for (const auto& word : split(words, ' ')) {
    if (!result.empty()) result += line + 1 + word.size() > longest_line ? '\n' : ' ';
    line = result.empty() || result.back() == '\n' ? word.size() : line + 1 + word.size();
    result += word;
  }
  return result;
}

Print print_in(std::string_view description) {
  Print print;
  print.words = quoted(description);
  if (print.words.empty()) print.words = spelt(description);
  // A sign that says "moon" shows no moon.
  std::string shown(description);
  if (const auto at = shown.find(print.words); !print.words.empty() && at != std::string::npos)
    shown.erase(at, print.words.size());
  const auto motifs = shape::motifs_in(shown);
  if (!motifs.empty()) print.motif = motifs.front();
  print.palette = shape::palette_in(shown);
  return print;
}

}  // namespace roomgen::create
